// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>
#include <vector>

namespace test_run_watch {

using CGAL::Volume_filling_curves::Run_progress;
using CGAL::Volume_filling_curves::Run_stage;
using CGAL::Volume_filling_curves::internal::check_run;
using CGAL::Volume_filling_curves::internal::for_each_block;
using CGAL::Volume_filling_curves::internal::for_each_index;
using CGAL::Volume_filling_curves::internal::Run_stopped;
using CGAL::Volume_filling_curves::internal::Run_watch;
using CGAL::Volume_filling_curves::internal::Watched_scope;

TEST(Run_watch, never_stops_by_itself)
{
  Run_watch watch;
  EXPECT_FALSE(watch.must_stop());
  EXPECT_TRUE(watch.leaves(1e9));
  EXPECT_NO_THROW(watch.check());
}

TEST(Run_watch, stops_for_good_when_its_time_is_over)
{
  Run_watch watch(0);
  EXPECT_TRUE(watch.must_stop());
  EXPECT_TRUE(watch.is_time_over());
  EXPECT_FALSE(watch.is_interrupted());
  EXPECT_FALSE(watch.leaves(0));
  EXPECT_THROW(watch.check(), Run_stopped);
}

TEST(Run_watch, does_not_leave_more_than_its_limit)
{
  const Run_watch watch(1000);
  EXPECT_TRUE(watch.leaves(1));
  EXPECT_FALSE(watch.leaves(1001));
}

TEST(Run_watch, asks_at_once_and_stops_when_told_to)
{
  std::size_t reports = 0;
  Run_watch watch(Run_watch::never, [&](const Run_progress&) { return ++reports < 1; });
  EXPECT_TRUE(watch.must_stop());
  EXPECT_TRUE(watch.is_interrupted());
  EXPECT_FALSE(watch.is_time_over());
  watch.begin(Run_stage::MEASURING);
  EXPECT_TRUE(watch.must_stop());
  EXPECT_EQ(reports, 1u);
}

TEST(Run_watch, reports_stages_and_fractions_that_never_fall)
{
  std::vector<Run_progress> reports;
  Run_watch watch(Run_watch::never, [&](const Run_progress& progress) {
    reports.push_back(progress);
    return true;
  });
  watch.note_fraction(0.5);
  watch.begin(Run_stage::BRANCHING);
  for(const double fraction : {0.25, 0.125, 2.}) {
    watch.note_fraction(fraction);
    watch.report();
  }
  ASSERT_EQ(reports.size(), 4u);
  EXPECT_EQ(reports[0].stage, Run_stage::BRANCHING);
  EXPECT_EQ(reports[0].fraction, 0);
  EXPECT_EQ(reports[1].fraction, 0.25);
  EXPECT_EQ(reports[2].fraction, 0.25);
  EXPECT_EQ(reports[3].fraction, 1);
}

TEST(Run_watch, stops_other_threads_but_calls_back_in_its_own_only)
{
  std::vector<std::thread::id> threads;
  Run_watch watch(Run_watch::never, [&](const Run_progress&) {
    threads.push_back(std::this_thread::get_id());
    return false;
  });
  bool is_stopped_before = true, is_stopped_after = false;
  std::thread([&] { is_stopped_before = watch.must_stop(); }).join();
  EXPECT_TRUE(watch.must_stop());
  std::thread([&] { is_stopped_after = watch.must_stop(); }).join();
  EXPECT_FALSE(is_stopped_before);
  EXPECT_TRUE(is_stopped_after);
  EXPECT_EQ(threads, std::vector<std::thread::id>{std::this_thread::get_id()});
}

TEST(Run_watch, grants_time_after_a_stop_without_asking_again)
{
  std::size_t reports = 0;
  Run_watch watch(Run_watch::never, [&](const Run_progress&) { return ++reports < 1; });
  EXPECT_TRUE(watch.must_stop());
  watch.grant(1000);
  EXPECT_FALSE(watch.must_stop());
  EXPECT_TRUE(watch.is_interrupted());
  EXPECT_EQ(reports, 1u);
}

// The number of indices that a loop comes to.
template <typename Tag>
std::size_t indices_seen(Run_watch* watch)
{
  const Watched_scope scope(watch);
  std::atomic<std::size_t> seen{0};
  try {
    for_each_index<Tag>(100000, [&](std::size_t) { ++seen; });
  } catch(const Run_stopped&) {
  }
  return seen;
}

TEST(Watched_scope, ends_loops_over_blocks_in_all_threads)
{
  Run_watch over(0), watch;
  EXPECT_EQ(indices_seen<CGAL::Sequential_tag>(&over), 0u);
  EXPECT_EQ(indices_seen<CGAL::Parallel_if_available_tag>(&over), 0u);
  EXPECT_EQ(indices_seen<CGAL::Parallel_if_available_tag>(&watch), 100000u);
  EXPECT_EQ(indices_seen<CGAL::Parallel_if_available_tag>(nullptr), 100000u);
}

TEST(Watched_scope, reaches_into_blocks_in_all_threads)
{
  Run_watch watch;
  const Watched_scope scope(&watch);
  std::atomic<std::size_t> outside{0};
  for_each_block<CGAL::Parallel_if_available_tag>(1000, 1, [&](std::size_t, std::size_t) {
    std::this_thread::sleep_for(std::chrono::microseconds(10)); // so that other threads join in
    if(Watched_scope::current() != &watch) ++outside;
  });
  EXPECT_EQ(outside, 0u);
}

TEST(Watched_scope, is_suspended_by_an_inner_one)
{
  Run_watch over(0);
  const Watched_scope scope(&over);
  EXPECT_THROW(check_run(), Run_stopped);
  {
    const Watched_scope inner(nullptr);
    EXPECT_NO_THROW(check_run());
  }
  EXPECT_THROW(check_run(), Run_stopped);
}

} // namespace test_run_watch
