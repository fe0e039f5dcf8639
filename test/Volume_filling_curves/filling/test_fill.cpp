// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/archetype_visitor.h"
#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

namespace test_fill {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using Ball = VFC::Ball_domain_3<Kernel>;
using Box = VFC::Box_domain_3<Kernel>;
using VFC::Filling_status;

TEST(Fill, keeps_the_ends_of_a_curve_between_two_ports)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const Point a(0.02, 0.5, 0.5), b(0.98, 0.5, 0.5);
  Curve curve = polyline({a, Point(0.5, 0.5, 0.5), b});
  curve.pin_ends();
  const auto result = VFC::fill(curve, box, preview(0.12));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  EXPECT_EQ(curve.point(0), a);
  EXPECT_EQ(curve.point(curve.number_of_nodes() - 1), b);
  expect_inside(curve, box);
  EXPECT_GT(coverage(curve, box, 0.12).fraction_within_r, 0.7);
}

TEST(Fill, returns_the_least_distances_of_its_curve)
{
  const Ball ball(Point(0, 0, 0), 1);
  Curve curve;
  const auto result = VFC::fill(curve, ball, preview(0.3));
  const auto bend = VFC::tightest_bend(curve);
  EXPECT_EQ(result.min_bend_radius, bend.radius);
  EXPECT_EQ(result.tightest_node, bend.node);
  const auto strands = VFC::min_strand_distance(curve, 0.3);
  EXPECT_EQ(result.min_strand_distance, strands.distance);
  EXPECT_EQ(result.closest_points, strands.points);
  const auto wall = VFC::min_wall_distance(curve, ball);
  EXPECT_EQ(result.min_wall_distance, wall.distance);
  EXPECT_EQ(result.point_nearest_to_wall, wall.point);
  EXPECT_EQ(result.crowded_fraction, VFC::crowded_fraction(curve, 0.3));
}

TEST(Fill, is_partial_where_it_is_crowded_and_not_with_the_thickness_that_fits)
{
  const Box rod(Point(0, 0, 0), Point(2, 0.2, 0.2));
  Curve curve;
  const auto result = VFC::fill(curve, rod, preview(0.12));
  ASSERT_GT(result.crowded_fraction, 0.05);
  EXPECT_LE(result.unfilled_fraction, 0.01);
  EXPECT_EQ(result.status, Filling_status::PARTIAL);
  EXPECT_NE(result.reason.find(" % of the length, r = 0.0849 would leave them room"),
            std::string::npos)
      << result.reason;
  Curve thinner;
  const auto fitting = VFC::fill(thinner, rod, preview(0.0849));
  EXPECT_EQ(fitting.status, Filling_status::CONVERGED);
  EXPECT_EQ(fitting.reason, "");
}

TEST(Fill, names_the_walls_that_crowd_it)
{
  const Box plate(Point(0, 0, 0), Point(2, 2, 0.2));
  Curve curve;
  const auto result = VFC::fill(curve, plate, preview(0.15));
  ASSERT_GT(result.crowded_fraction, 0.05);
  EXPECT_EQ(result.status, Filling_status::PARTIAL);
  EXPECT_NE(result.reason.find("r = 0.075 would fit; strands are nearer than r along"),
            std::string::npos)
      << result.reason;
}

TEST(Fill, is_reproducible_and_scales)
{
  Curve once, twice, scaled;
  const Ball ball(Point(0, 0, 0), 1), large(Point(0, 0, 0), 4);
  VFC::fill(once, ball, preview(0.2).number_of_iterations(60));
  VFC::fill<CGAL::Parallel_if_available_tag>(twice, ball, preview(0.2).number_of_iterations(60));
  VFC::fill(scaled, large, preview(0.8).number_of_iterations(60));
  ASSERT_EQ(once.number_of_nodes(), twice.number_of_nodes());
  ASSERT_EQ(once.number_of_nodes(), scaled.number_of_nodes());
  for(std::size_t v = 0; v < once.number_of_nodes(); ++v) {
    EXPECT_EQ(once.point(v), twice.point(v));
    const Point& p = once.point(v);
    EXPECT_EQ(Point(4 * p.x(), 4 * p.y(), 4 * p.z()), scaled.point(v));
  }
}

TEST(Fill, refuses_curves_that_are_not_inside)
{
  const Ball ball(Point(0, 0, 0), 1);
  Curve crossing = polyline({Point(0, 0, 0), Point(0, 0, 2)});
  EXPECT_THROW(VFC::fill(crossing, ball, preview(0.2)), std::invalid_argument);
  Curve touching = polyline({Point(0, 0, 0), Point(0, 0, 1)});
  EXPECT_THROW(VFC::fill(touching, ball, preview(0.2)), std::invalid_argument);
}

TEST(Fill, reports_where_the_curve_did_not_get_to)
{
  const Box box(Point(0, 0, 0), Point(4, 1, 1));
  Curve curve;
  const auto result =
      VFC::fill(curve, box, preview(0.1).number_of_iterations(5).start(VFC::Filling_start::CIRCLE));
  EXPECT_EQ(result.status, Filling_status::LIMIT);
  ASSERT_FALSE(result.empty_regions.empty());
  EXPECT_GT(result.empty_regions.front().volume, 0.5);
  EXPECT_TRUE(box.is_inside(result.empty_regions.front().point));
}

TEST(Fill, ends_without_convergence_where_a_length_is_out_of_reach)
{
  const Ball ball(Point(0, 0, 0), 1);
  for(const double length : {1., 1e-3}) {
    Curve curve;
    const auto result = VFC::fill(curve, ball, np::length(length));
    EXPECT_EQ(result.status, Filling_status::LENGTH_NOT_REACHED);
    EXPECT_LE(result.thickness, 2.1);
    EXPECT_EQ(result.reason.substr(0, 14), "the length is ");
    expect_inside(curve, ball);
  }
}

TEST(Fill, takes_a_struct_of_parameters_and_a_visitor)
{
  const Ball ball(Point(0, 0, 0), 1);
  Curve first, second;
  VFC::Filling_parameters<> p;
  p.thickness = 0.3;
  p.number_of_iterations = 2;
  archetypes::Visitor visitor(0);
  VFC::fill(first, ball, p, std::ref(visitor));
  VFC::fill(second, ball, np::thickness(0.3).number_of_iterations(2));
  EXPECT_EQ(visitor.calls, "sgigi");
  ASSERT_EQ(first.number_of_nodes(), second.number_of_nodes());
  for(std::size_t v = 0; v < first.number_of_nodes(); ++v)
    EXPECT_EQ(first.point(v), second.point(v));
}

// the message of the error, or nothing
template <typename Parameters>
std::string complaint(const Parameters& p)
{
  try {
    Curve curve;
    VFC::fill(curve, Ball(Point(0, 0, 0), 1), p);
  } catch(const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Fill, refuses_parameters_by_name)
{
  EXPECT_EQ(complaint(np::length(3).thickness(0.2)),
            "length is 3, but a thickness is given as well");
  EXPECT_EQ(complaint(np::length(3).thickness([](const Point&) { return 0.2; })),
            "length is 3, but a thickness is given as well");
  EXPECT_EQ(complaint(np::length(-3)), "length is -3, but must be finite and not negative");
  EXPECT_EQ(complaint(np::thickness(-1)), "thickness is -1, but must be finite and not negative");
  EXPECT_EQ(complaint(np::thickness(1e300))
                .find("thickness is 1e+300, but must not be larger than the domain"),
            0u);
  EXPECT_EQ(complaint(np::time_limit(-1)), "time_limit is -1, but must not be negative");
}

} // namespace test_fill
