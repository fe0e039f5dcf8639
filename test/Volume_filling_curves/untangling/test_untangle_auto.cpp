// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <thread>

// The strategy AUTO makes nothing worse than it came, and searches where that helps.
namespace test_untangle_auto {

using namespace untangle_test;
using CGAL::Volume_filling_curves::Default_curve_flow_visitor;
using CGAL::Volume_filling_curves::Isotopy_certificate;
using CGAL::Volume_filling_curves::make_hard_unknot;
using CGAL::Volume_filling_curves::ropelength;
using CGAL::Volume_filling_curves::Search_progress;
using CGAL::Volume_filling_curves::Untangling_strategy;

constexpr double ropelength_of_circles = 2 * CGAL_PI;

// Two circles through the center of each other: the tight Hopf link, of ropelength 8 pi.
Network hopf_link()
{
  Polygon first = circle(64), second;
  for(const Vector& p : first) second.emplace_back(p.x() + 1, 0, p.y());
  return internal::closed_network({first, second});
}

TEST(Untangle_auto, keeps_an_input_that_is_tighter)
{
  const Network start = hopf_link();
  Network by_flow = start, by_auto = start;
  untangle(by_flow, parameters::strategy(Untangling_strategy::FLOW));
  ASSERT_GT(ropelength(by_flow), 1.1 * ropelength(start));
  Isotopy_certificate certificate;
  const Untangling_result result =
      untangle(by_auto, parameters::certificate(std::ref(certificate)));
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_EQ(result.link, Link_status::LINKED);
  EXPECT_TRUE(result.is_input);
  EXPECT_EQ(contents(by_auto), contents(start));
  EXPECT_TRUE(verify_certificate(certificate, start, by_auto).is_valid);
}

TEST(Untangle_auto, moves_on_for_the_thickness_that_is_asked_for)
{
  Network curve = hopf_link();
  const Untangling_result result = untangle(curve, parameters::thickness(0.2));
  EXPECT_FALSE(result.is_input);
  EXPECT_EQ(result.thickness, 0.2);
}

TEST(Untangle_auto, makes_round_polygons_rounder)
{
  Network curve = internal::closed_network({circle(16)});
  const double before = ropelength(curve);
  const Untangling_result result = untangle(curve);
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  EXPECT_LT(ropelength(curve), before);
}

TEST(Untangle_auto, keeps_rings_that_are_round)
{
  const Network start = internal::closed_network({circle(64), circle(64, 1, Vector(5, 0, 0))});
  Network curve = start;
  const Untangling_result result = untangle(curve);
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  EXPECT_EQ(result.link, Link_status::TRIVIAL);
  EXPECT_LE(ropelength(curve), ropelength(start));
}

TEST(Untangle_auto, ends_unknots_round)
{
  for(int seed = 0; seed < 5; ++seed) {
    Network curve = make_hard_unknot(200, 20, static_cast<unsigned>(seed));
    const Untangling_result result = untangle(curve);
    EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
    EXPECT_TRUE(result.is_round);
    EXPECT_GE(curve.number_of_nodes(), 64u);
    EXPECT_LT(ropelength(curve), 1.002 * ropelength_of_circles);
  }
}

TEST(Untangle_auto, says_where_an_unknot_is_not_round)
{
  Network pinned = make_hard_unknot(200, 20, 1);
  pinned.set_pinned(0);
  EXPECT_FALSE(untangle(pinned).is_round);
  Network by_flow = make_hard_unknot(200, 20, 1);
  EXPECT_FALSE(untangle(by_flow, parameters::strategy(Untangling_strategy::FLOW)).is_round);
}

// The search does not find fewer crossings than there are.
TEST(Untangle_auto, flows_from_the_input_if_that_is_as_simple)
{
  for(const std::string word : {"1 1 1", "1 -2 1 -2"}) {
    Network by_flow = braid(word, 150), by_auto = by_flow;
    const Untangling_result flow =
        untangle(by_flow, parameters::strategy(Untangling_strategy::FLOW));
    const Untangling_result result = untangle(by_auto);
    EXPECT_EQ(result.searches, 1u);
    EXPECT_EQ(result.status, flow.status) << word;
    EXPECT_EQ(contents(by_auto), contents(by_flow)) << word;
  }
}

// Makes every sweep and every iteration last at least a tenth of the time limit.
struct Slow_visitor : Default_curve_flow_visitor
{
  static constexpr double limit = 0.2; // seconds

  static bool wait()
  {
    std::this_thread::sleep_for(std::chrono::duration<double>(limit / 10));
    return true;
  }

  std::size_t calls_of_search = 0;

  bool on_search(const Search_progress&)
  {
    ++calls_of_search;
    return wait();
  }

  template <typename Flow>
  bool go_further(const Flow&)
  {
    return wait();
  }
};

TEST(Untangle_auto, searches_for_a_share_of_the_time_only)
{
  Network curve = braid("1 -2 3 -2 1 -2 3 -2 1 -2", 300);
  Slow_visitor visitor;
  const Untangling_result result =
      untangle(curve, parameters::time_limit(Slow_visitor::limit).visitor(std::ref(visitor)));
  EXPECT_EQ(result.status, Untangling_status::LIMIT);
  EXPECT_LE(visitor.calls_of_search, 3u) << "a quarter of ten";
}

} // namespace test_untangle_auto
