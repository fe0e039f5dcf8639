// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_round_test_support.h"
#include "support/polygon_test_support.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage_runner.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_visitor.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// Bend radii and distances between strands that conflict with a thickness, a length or the domain.
namespace test_fill_round_conflicts {

using namespace fill_round_test;

// With r / 2 the flow and the projection of strands would not come to rest.
TEST(Fill_round, thickness_grows_with_the_strand_distance)
{
  const Box slab({0, 0, 0}, {2, 1, 1});
  Curve curve, field_curve;
  const Result result = VFC::fill(curve, slab, np::thickness(.15).strand_distance(.36));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  EXPECT_DOUBLE_EQ(result.thickness, .2);
  EXPECT_GE(result.min_strand_distance, .36);
  const auto field = [](const Point& p) { return p.x() < 1 ? .1 : .25; };
  const Result varied = VFC::fill(field_curve, slab, np::thickness(field).strand_distance(.36));
  EXPECT_GE(varied.min_strand_distance, .36);
  EXPECT_GT(varied.thickness, .2);
  EXPECT_LT(varied.thickness, .25);
}

// A curve cannot be denser than its bends allow.
TEST(Fill_round, takes_a_larger_thickness_for_wide_bends)
{
  for(const double bend_radius : {1.5, 2.}) {
    Curve curve;
    const Result result = VFC::fill(curve, box, np::thickness(1).bend_radius(bend_radius));
    EXPECT_NEAR(result.thickness, bend_radius, 1e-9);
    EXPECT_GE(VFC::length(curve), CGAL_PI * bend_radius) << "the curve has vanished";
    if(result.status == Filling_status::CONVERGED || result.status == Filling_status::PARTIAL)
      expect_shape(curve, bend_radius, 1.6 * bend_radius);
    else
      EXPECT_EQ(result.status, Filling_status::CONSTRAINT_NOT_REACHED);
    expect_inside(curve, box);
  }
}

TEST(Fill_round, does_not_call_a_domain_thin_that_has_room_for_the_larger_thickness)
{
  const Plate plate(polygons::plate());
  Curve curve;
  const auto result =
      VFC::fill(curve, plate, np::thickness(0.01).bend_radius(0.1).number_of_iterations(1));
  EXPECT_NEAR(result.thickness_fit.thickness, 0.1, 1e-9);
  EXPECT_LT(result.thickness_fit.thin_fraction, 0.05);
}

// The length of so short a curve varies by more than is promised from one thickness to the next.
TEST(Fill_round, reaches_lengths_with_few_nodes)
{
  for(const std::size_t seed : {1u, 5u, 6u}) {
    Curve curve;
    const Result result =
        VFC::fill(curve, Box({0, 0, 0}, {4, 2, 2}), np::length(25).random_seed(seed));
    EXPECT_EQ(result.status, Filling_status::CONVERGED) << seed;
    EXPECT_NEAR(VFC::length(curve), 25, 0.5) << seed;
  }
}

// The strands are farther apart than the plate is thick: r is about 3.1.
TEST(Fill_round, reaches_a_length_in_a_plate_that_is_thinner_than_r)
{
  const Box plate({0, 0, 0}, {20, 20, 1});
  for(const std::size_t seed : {1u, 5u, 7u}) {
    Curve curve;
    const Result result = VFC::fill(curve, plate, np::length(61).random_seed(seed));
    EXPECT_EQ(result.status, Filling_status::CONVERGED) << seed << ": " << result.reason;
    EXPECT_NEAR(VFC::length(curve), 61, 0.02 * 61);
    EXPECT_NEAR(result.thickness, 3.1, 0.2);
    expect_inside(curve, plate);
  }
}

// For the sake of a length, r grows to half of the diagonal; bends may ask for more.
TEST(Fill_round, gets_no_thicker_than_its_domain_or_its_bends_for_the_sake_of_a_length)
{
  const Box cube({0, 0, 0}, {2, 2, 2});
  for(const double bend_radius : {0.5, 1.9}) {
    Curve curve;
    const Result result = VFC::fill(curve, cube, np::length(0.5).bend_radius(bend_radius));
    EXPECT_EQ(result.status, Filling_status::LENGTH_NOT_REACHED);
    EXPECT_NEAR(result.thickness, (std::max)(std::sqrt(3.), bend_radius), 1e-9);
    EXPECT_EQ(result.reason.substr(0, 14), "the length is ");
    EXPECT_GT(VFC::length(curve), 2) << "the curve has vanished";
    expect_inside(curve, cube);
  }
}

TEST(Fill_round, gets_no_thinner_than_its_bends_allow_for_the_sake_of_a_length)
{
  Curve curve;
  const Result result = VFC::fill(curve, box, np::length(1000).bend_radius(1));
  EXPECT_EQ(result.status, Filling_status::LENGTH_NOT_REACHED);
  EXPECT_NEAR(result.thickness, 1, 1e-9);
  expect_inside(curve, box);
}

TEST(Fill_round, stops_polishing_where_the_limits_are_out_of_reach)
{
  const Box rod({0, 0, 0}, {30, 0.8, 0.8}); // narrower than a turn
  Curve curve;
  const Result result = VFC::fill(curve, rod, np::thickness(1));
  EXPECT_EQ(result.status, Filling_status::CONSTRAINT_NOT_REACHED);
  EXPECT_EQ(result.statistics.iterations, 23u) << "to open, to bend, and one to polish";
}

// A tight helix, of whose nodes every sixth is pinned. Bent on, it doubled its length in every
// second step.
TEST(Fill_round, stops_bending_a_curve_that_grows_without_end)
{
  const Box bar({-1, -0.5, -0.5}, {1, 0.5, 0.5});
  std::vector<Point> helix;
  for(int k = 0; k < 300; ++k)
    helix.push_back({-0.4 + 0.8 * k / 300, 0.25 * std::cos(0.2 * k), 0.25 * std::sin(0.2 * k)});
  Curve curve(std::vector<std::vector<Point>>{helix});
  for(std::size_t v = 0; v < curve.number_of_nodes(); v += 6) curve.set_pinned(v);
  const double former_length = VFC::length(curve);
  const Result result = VFC::fill(curve, bar, np::thickness(0.1));
  EXPECT_EQ(result.status, Filling_status::CONSTRAINT_NOT_REACHED);
  EXPECT_LT(VFC::length(curve), 20 * former_length);
  EXPECT_LT(result.statistics.iterations, 50u);
}

TEST(Fill_round, says_where_a_constraint_is_not_reached)
{
  const Box small({0, 0, 0}, {1, 1, 1}); // no ring with that radius fits in
  Curve curve;
  const Result result = VFC::fill(curve, small, np::thickness(0.25).bend_radius(0.9));
  EXPECT_EQ(result.status, Filling_status::CONSTRAINT_NOT_REACHED);
  EXPECT_GE(VFC::length(curve), 1) << "the curve has vanished";
  ASSERT_FALSE(result.shape_excesses.empty());
  EXPECT_TRUE(result.shape_excesses.front().is_bend);
  EXPECT_NEAR(result.shape_excesses.front().value, VFC::min_bend_radius(curve), 1e-9);
  EXPECT_EQ(result.shape_excesses.front().limit, 0.9);
  EXPECT_NE(result.reason.find("bends with a radius of"), std::string::npos) << result.reason;
}

// Nodes that are pinned can neither bend nor part; the curve has settled nevertheless.
TEST(Fill_round, does_not_call_a_curve_stalled_that_cannot_be_polished)
{
  using Flow = VFC::Curve_flow_3<Traits, Box>;
  constexpr int n = 12;
  const std::vector<Point> corners = {{1, 1, 3}, {5, 1, 3}, {5, 5, 3}, {1, 5, 3}, {1, 1, 3}};
  std::vector<Point> points;
  for(std::size_t side = 0; side < 4; ++side)
    for(int k = 0; k < n; ++k)
      points.push_back(corners[side] + k * (corners[side + 1] - corners[side]) / n);
  points.push_back(points.front());
  Curve square(points);
  for(const std::size_t v : square.nodes()) square.set_pinned(v, true);
  VFC::Isotopy_guard_3<Traits, Box> guard(square, box);
  VFC::Filling_parameters<Point> parameters;
  parameters.bend_radius = 2.5;
  VFC::internal::Run_watch watch;
  VFC::Default_curve_flow_visitor visitor;
  VFC::internal::Run_visitor_of<Flow, VFC::Default_curve_flow_visitor> visitor_of_run(visitor);
  VFC::internal::Filling_state state;
  const Flow::Thickness thickness(1);
  VFC::internal::Filling_stage_runner<Flow> runner(guard, parameters, thickness, watch,
                                                   visitor_of_run, state);
  runner.run(VFC::internal::Filling_stage::polishing(), thickness);
  EXPECT_FALSE(runner.flow().is_shaped());
  EXPECT_EQ(state.statistics.iterations, 5u);
  EXPECT_EQ(runner.end(), std::nullopt);
}

TEST(Fill_round, refuses_a_radius_beyond_the_domain)
{
  Curve curve;
  EXPECT_THROW(VFC::fill(curve, box, np::bend_radius(100)), std::invalid_argument);
  EXPECT_THROW(VFC::fill(curve, box, np::bend_radius(-1)), std::invalid_argument);
  EXPECT_THROW(VFC::fill(curve, box, np::strand_distance(100)), std::invalid_argument);
}

} // namespace test_fill_round_conflicts
