// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Arc splines are smooth, and have the bend radius of each corner.

#include "support/arc_spline_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/arc_spline.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_arc_spline {

using namespace arc_spline_test;

TEST(Arc_spline, of_a_regular_polygon_is_its_inscribed_circle)
{
  for(const std::size_t n : {3u, 4u, 7u, 100u}) {
    const Curve polygon = curve_of({regular_polygon(n)});
    const Spline spline = arc_spline(polygon);
    const double radius = std::cos(CGAL_PI / static_cast<double>(n));
    EXPECT_TRUE(spline.is_certified);
    EXPECT_EQ(spline.number_of_arcs, n);
    EXPECT_EQ(spline.number_of_segments, 0u) << "arcs of equal edges end in one point";
    EXPECT_NEAR(spline.length, 2 * CGAL_PI * radius, 1e-12);
    EXPECT_NEAR(spline.max_distance, 1 - radius, 1e-12);
    EXPECT_TRUE(spline.paths[0].is_closed);
    expect_smooth(spline);
    expect_arcs_of_corners(spline, polygon);
  }
}

TEST(Arc_spline, has_the_bend_radius_of_each_corner)
{
  for(const Curve& curve :
      {make_torus_knot(2, 3, 100, 1), make_torus_knot(3, 5, 300, 1), make_random_polygon(50, 1),
       make_closed_braid(parse_braid_word("1 -2 1 -2"), 300, 1)}) {
    const Spline spline = arc_spline(curve);
    EXPECT_EQ(spline.number_of_arcs, curve.number_of_nodes());
    expect_smooth(spline);
    expect_arcs_of_corners(spline, curve);
  }
}

TEST(Arc_spline, has_no_arcs_at_straight_corners_and_ends)
{
  const Curve straight =
      curve_of({{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(3, 0, 0), Point_3(3, 1, 0)}});
  const Spline spline = arc_spline(straight);
  EXPECT_TRUE(spline.is_certified);
  EXPECT_EQ(spline.number_of_arcs, 1u);
  EXPECT_EQ(spline.number_of_segments, 4u - 1);
  EXPECT_FALSE(spline.paths[0].is_closed);
  EXPECT_EQ(spline.paths[0].pieces.front().start, straight.point(0));
  EXPECT_EQ(spline.paths[0].pieces.back().end, straight.point(3));
  const Spline segment = arc_spline(curve_of({{Point_3(0, 0, 0), Point_3(1, 0, 0)}}));
  EXPECT_TRUE(segment.is_certified);
  EXPECT_EQ(segment.min_radius, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(arc_spline(Curve()).is_certified);
}

TEST(Arc_spline, bends_as_tightly_as_a_nearly_reversing_corner)
{
  const double angle = 1e-7;
  const Curve spike = curve_of({{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, angle, 0)}});
  const Spline spline = arc_spline(spike);
  EXPECT_TRUE(spline.is_certified);
  EXPECT_NEAR(spline.min_radius, angle / 4, 1e-9 * angle);
  EXPECT_NEAR(spline.max_distance, 0.5, 1e-6);
  EXPECT_THROW(
      (void)arc_spline(curve_of({{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(.5, 0, 0)}})),
      std::invalid_argument);
}

TEST(Arc_spline, ends_at_junctions)
{
  const Curve theta(Points{Point_3(0, 0, 0), Point_3(2, 0, 0), Point_3(1, 1, 0), Point_3(1, 0, 1)},
                    {{0, 1}, {2, 0}, {2, 1}, {0, 3}, {3, 1}}); // edges of any direction
  const Spline spline = arc_spline(theta);
  EXPECT_TRUE(spline.is_certified);
  ASSERT_EQ(spline.paths.size(), 3u);
  EXPECT_EQ(spline.number_of_arcs, 2u);
  for(const auto& path : spline.paths) {
    EXPECT_FALSE(path.is_closed);
    EXPECT_EQ(path.component, 0u);
    EXPECT_FALSE(path.pieces.front().is_arc());
    EXPECT_FALSE(path.pieces.back().is_arc());
  }
  expect_smooth(spline);
}

TEST(Arc_spline, scales_with_the_curve)
{
  const double factor = std::ldexp(1, 100);
  const auto points = [&](double scale) {
    Points all;
    const Curve polygon = make_random_polygon(60, 7);
    for(const Point_3& p : polygon.points())
      all.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    all.push_back(all.front());
    return all;
  };
  const Spline small = arc_spline(curve_of({points(1)})),
               large = arc_spline(curve_of({points(factor)}));
  EXPECT_EQ(conflicting_nodes(small), conflicting_nodes(large));
  EXPECT_EQ(factor * small.length, large.length);
  EXPECT_EQ(factor * small.min_radius, large.min_radius);
}

// The squares of an edge's length underflow.
TEST(Arc_spline, rounds_corners_beside_the_shortest_edges)
{
  for(const double tiny : {1e-160, 1e-162, 1e-170, 1e-300}) {
    const Spline closed =
        arc_spline(curve_of({{{0, 0, 0}, {tiny, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}));
    EXPECT_TRUE(closed.is_certified);
    EXPECT_EQ(closed.number_of_arcs, 3u);
    EXPECT_EQ(closed.min_radius, tiny / 2);
    const double large_arc = 3 * CGAL_PI / 8 / std::tan(3 * CGAL_PI / 8);
    EXPECT_NEAR(closed.length, std::sqrt(2) + 2 * large_arc, 1e-12);
    expect_smooth(closed);
    const Spline open = arc_spline(curve_of({{{0, 0, 0}, {tiny, 0, 0}, {1, 0, 1}, {0, 1, 0}}}));
    EXPECT_TRUE(open.is_certified);
    EXPECT_EQ(open.number_of_arcs, 2u);
    expect_smooth(open);
  }
}

// Half of the least positive double is 0: there is no room for an arc.
TEST(Arc_spline, beside_an_edge_without_room_for_an_arc_is_not_certified)
{
  const double least = std::numeric_limits<double>::denorm_min();
  const Spline spline =
      arc_spline(curve_of({{{0, 0, 0}, {least, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}));
  EXPECT_FALSE(spline.is_certified);
  EXPECT_EQ(conflicting_nodes(spline), std::vector<std::size_t>{0});
}

TEST(Arc_spline, ends_when_asked_to)
{
  EXPECT_THROW((void)arc_spline(make_random_polygon(100, 1),
                                parameters::progress([](const Run_progress&) { return false; })),
               Run_interrupted);
}

} // namespace test_arc_spline
