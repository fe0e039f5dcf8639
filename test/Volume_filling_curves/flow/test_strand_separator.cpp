// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/flow/Strand_separator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Strands that almost touch part, and let the flow pass.
namespace test_strand_separator {

using namespace untangle_test;
using CGAL::Volume_filling_curves::make_random_polygon;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<Traits>;

// two paths of two edges, one above the other, crossing or parallel
Network two_paths(double gap, bool is_crossing)
{
  std::vector<Vector> points;
  for(const double x : {-1., 0., 1.}) points.push_back({x, 0.3, 0});
  for(const double x : {-1., 0., 1.})
    points.push_back(is_crossing ? Vector(0.3, x, gap) : Vector(x + 0.2, 0.3, gap));
  return network_of(points, {{0, 1}, {1, 2}, {3, 4}, {4, 5}});
}

double distance(const Network& curve)
{
  double least = 1;
  for(const std::size_t e : {0u, 1u})
    for(const std::size_t f : {2u, 3u}) {
      const auto p = [&](std::size_t v) { return internal::to_vector(curve.point(v)); };
      least = (std::min)(least, std::sqrt(internal::squared_segment_distance(
                                    p(curve.source(e)), p(curve.target(e)), p(curve.source(f)),
                                    p(curve.target(f)))));
    }
  return least;
}

TEST(Strand_separator, moves_strands_apart)
{
  for(const bool is_crossing : {true, false})
    for(const double gap : {1e-3, 1e-12, 1e-30}) {
      Network curve = two_paths(gap, is_crossing);
      Guard guard(curve);
      for(int k = 0; k < 5; ++k) internal::Strand_separator<Guard>(guard, 0.1, 1)();
      EXPECT_GT(distance(curve), 0.05) << gap;
      EXPECT_LT(distance(curve), 0.3) << gap;
    }
}

TEST(Strand_separator, leaves_alone_what_is_far_apart_or_pinned)
{
  Network far = two_paths(0.2, true), pinned = two_paths(1e-3, true);
  for(std::size_t v = 0; v < pinned.number_of_nodes(); ++v) pinned.set_pinned(v);
  for(Network* curve : {&far, &pinned}) {
    const auto before = contents(*curve);
    Guard guard(*curve);
    EXPECT_FALSE(internal::Strand_separator<Guard>(guard, 0.1, 1)());
    EXPECT_EQ(contents(*curve), before);
  }
}

// A hairpin bends back on itself; that is no other strand.
TEST(Strand_separator, leaves_alone_what_is_near_along_the_curve)
{
  std::vector<Vector> points;
  for(const double x : {1., 0.9, 0.8}) points.push_back({x, 0, 0});
  for(const double x : {0.8, 0.9, 1.}) points.push_back({x, 0.05, 0});
  Network curve = network_of(points, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
  Guard guard(curve);
  EXPECT_FALSE(internal::Strand_separator<Guard>(guard, 0.2, 1)());
  EXPECT_TRUE(internal::Strand_separator<Guard>(guard, 0.06, 1)()); // 0.25 apart along the curve
}

// Of polygons with random edges every fourth has strands that no step of the flow moves apart.
TEST(Strand_separator, lets_random_polygons_flow)
{
  constexpr auto flow = CGAL::Volume_filling_curves::Untangling_strategy::FLOW;
  for(const unsigned seed : {6u, 9u, 12u}) {
    Network polygon = make_random_polygon(200, seed);
    const Untangling_result result = untangle(polygon, parameters::strategy(flow));
    EXPECT_TRUE(result.status == Untangling_status::UNKNOTTED ||
                result.status == Untangling_status::CONVERGED);
    expect_valid(polygon, 200);
  }
}

} // namespace test_strand_separator
