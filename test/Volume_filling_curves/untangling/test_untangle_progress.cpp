// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <set>
#include <thread>

// Runs report their progress from the start, and end on request, even within a step. The tests
// count calls, not times.
namespace test_untangle_progress {

using namespace untangle_test;
using CGAL::Volume_filling_curves::Ball_domain_3;
using CGAL::Volume_filling_curves::Curve_flow_parameters;
using CGAL::Volume_filling_curves::Default_curve_flow_visitor;
using CGAL::Volume_filling_curves::Isotopy_certificate;
using CGAL::Volume_filling_curves::Run_progress;
using CGAL::Volume_filling_curves::Run_stage;
using CGAL::Volume_filling_curves::Untangling_strategy;
using CGAL::Volume_filling_curves::verify_certificate;
using internal::Run_stopped;
using internal::Run_watch;
using Flow = CGAL::Volume_filling_curves::Curve_flow_3<>;
using Guard = Flow::Guard;

const auto lowering = parameters::lower_ropelength(true);

Network trefoil()
{
  return tangled(braid("1 1 1", 60), 2, 300);
}

TEST(Untangle_progress, has_all_stages_and_changes_nothing)
{
  Network watched = trefoil(), unwatched = watched;
  std::set<Run_stage> stages;
  Run_progress last;
  const auto note = [&](const Run_progress& progress) {
    stages.insert(progress.stage);
    EXPECT_GE(progress.iterations, last.iterations);
    EXPECT_GE(progress.seconds, last.seconds);
    if(progress.stage != Run_stage::SEARCHING) last = progress;
    return true;
  };
  const Untangling_result result = untangle(watched, lowering.progress(note));
  EXPECT_EQ(stages, (std::set<Run_stage>{Run_stage::PREPARING, Run_stage::SEARCHING,
                                         Run_stage::FLOWING, Run_stage::TIGHTENING}));
  EXPECT_EQ(last.iterations, result.statistics.iterations);
  EXPECT_GT(last.length, 0);
  EXPECT_GT(last.nodes, 0u);
  untangle(unwatched, lowering);
  EXPECT_EQ(contents(watched), contents(unwatched));
}

TEST(Untangle_progress, ends_in_every_stage_with_a_certified_curve)
{
  const Network start = trefoil();
  for(const Run_stage stage :
      {Run_stage::PREPARING, Run_stage::SEARCHING, Run_stage::FLOWING, Run_stage::TIGHTENING}) {
    Network curve = start;
    Isotopy_certificate certificate;
    std::size_t calls = 0;
    const auto end_there = [&](const Run_progress& progress) {
      if(progress.stage == stage) ++calls;
      return progress.stage != stage;
    };
    const Untangling_result result =
        untangle(curve, lowering.progress(end_there).certificate(std::ref(certificate)));
    EXPECT_EQ(result.status, Untangling_status::INTERRUPTED) << stage;
    EXPECT_EQ(calls, 1u) << stage;
    EXPECT_FALSE(result.is_ropelength_lowered);
    EXPECT_TRUE(verify_certificate(certificate, start, curve).is_valid) << stage;
  }
}

// Counts steps and motions after the progress has ended the run.
struct Counting_visitor : Default_curve_flow_visitor
{
  template <typename Flow>
  void on_iteration(const Flow&)
  {
    if(is_over) ++late_iterations;
  }

  bool is_over = false;
  std::size_t late_iterations = 0;
};

TEST(Untangle_progress, ends_at_each_iteration)
{
  for(const std::size_t last : {1u, 2u, 7u}) {
    Network curve = trefoil();
    Counting_visitor visitor;
    const auto end_there = [&](const Run_progress& progress) {
      visitor.is_over = progress.iterations >= last;
      return !visitor.is_over;
    };
    const Untangling_result result = untangle(curve, parameters::strategy(Untangling_strategy::FLOW)
                                                         .progress(end_there)
                                                         .visitor(std::ref(visitor)));
    EXPECT_EQ(result.status, Untangling_status::INTERRUPTED);
    EXPECT_EQ(result.statistics.iterations, last);
    EXPECT_LE(visitor.late_iterations, 1u) << "that after which it was asked";
  }
}

TEST(Untangle_progress, ends_in_a_domain)
{
  const Ball_domain_3<> ball(Network::Point_3(0, 0, 0), 1);
  Network curve = trefoil();
  const Untangling_result result =
      untangle(curve, ball, parameters::thickness(0.05).progress([](const Run_progress& progress) {
        return progress.stage != Run_stage::FLOWING;
      }));
  EXPECT_EQ(result.status, Untangling_status::INTERRUPTED);
  expect_valid(curve, trefoil().number_of_nodes());
}

TEST(Untangle_progress, ends_while_the_input_is_checked)
{
  Network curve = trefoil();
  Run_watch over(0), never;
  EXPECT_FALSE(internal::does_in_time(over, [&] { internal::check_embedded(curve); }));
  EXPECT_TRUE(internal::does_in_time(never, [&] { internal::check_embedded(curve); }));
  const Untangling_result result = untangle(curve, parameters::time_limit(0));
  EXPECT_EQ(result.status, Untangling_status::LIMIT);
  EXPECT_EQ(result.proofs.size(), 1u);
  expect_valid(curve, trefoil().number_of_nodes());
  EXPECT_EQ(result.link, Link_status::NOT_A_LINK);
  Network link = braid("1 1", 50000); // a check of milliseconds
  const auto wait = [](const Run_progress&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(200)); // longer than the run's grace
    return true;
  };
  EXPECT_EQ(untangle(link, parameters::time_limit(0).progress(wait)).link, Link_status::UNDECIDED);
}

// A watch whose time is over ends each part of a step; the curve is embedded, without garbage.
TEST(Untangle_progress, ends_within_a_step)
{
  Network curve = trefoil();
  const Network start = curve;
  Guard guard(curve);
  Run_watch over(0);
  guard.set_watch(&over);
  Curve_flow_parameters flow_parameters;
  EXPECT_THROW((Flow(guard, flow_parameters)), Run_stopped) << "measuring the thickness";
  EXPECT_EQ(contents(curve), contents(start));
  flow_parameters.thickness = 0.02;
  EXPECT_THROW((Flow(guard, flow_parameters)), Run_stopped) << "finding the direction";
  EXPECT_EQ(curve.number_of_nodes(), start.number_of_nodes()) << "remeshing";
  guard.set_watch(nullptr);
  Flow flow(guard, flow_parameters);
  const auto remeshed = contents(curve);
  guard.set_watch(&over);
  EXPECT_THROW(flow.step(), Run_stopped);
  EXPECT_EQ(contents(curve), remeshed) << "the motion is certified as a whole";
  internal::Ropelength_descent<Guard, CGAL::Sequential_tag> descend(guard, 0.01);
  EXPECT_FALSE(descend([] { return true; }));
  EXPECT_TRUE(descend.is_stopped());
  expect_valid(curve, start.number_of_nodes());
}

} // namespace test_untangle_progress
