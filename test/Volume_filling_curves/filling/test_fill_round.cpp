// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fillings with a bend radius and a distance of strands. All is measured anew.

#include "support/fill_test_support.h"
#include "support/polygon_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage_runner.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_fill_round {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using VFC::Filling_status;
using Box = VFC::Box_domain_3<Kernel>;
using Result = VFC::Filling_result<Point>;

const Box box({0, 0, 0}, {6, 6, 6});

// By the measures, which count strands from half of a turn of the bend radius on.
void expect_shape(const Curve& curve, double bend_radius, double strand_distance)
{
  EXPECT_GE(VFC::min_bend_radius(curve), (1 - 1e-9) * bend_radius);
  EXPECT_GE(VFC::min_clearance(curve, CGAL_PI * bend_radius), (1 - 1e-9) * strand_distance);
}

std::vector<Point> points(const Curve& curve)
{
  return {curve.points().begin(), curve.points().end()};
}

TEST(Fill_round, keeps_bends_and_strands_in_a_box)
{
  const Box wide({0, 0, 0}, {7, 7, 7});
  Curve curve;
  VFC::Isotopy_certificate certificate;
  const Result result = VFC::fill(curve, wide, np::thickness(1).certificate(std::ref(certificate)));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  EXPECT_TRUE(result.shape_excesses.empty());
  expect_shape(curve, 0.85, 1.6);
  expect_inside(curve, wide);
  EXPECT_GE(coverage(curve, wide, 1).fraction_within_r, 0.8);
  const Curve start(result.start);
  EXPECT_TRUE(VFC::verify_certificate(certificate, start, curve, wide).is_valid);
}

// Targets of strands that pass through each other left them hooked into each other.
TEST(Fill_round, leaves_no_hooks)
{
  for(std::size_t seed = 0; seed < 10; ++seed) {
    Curve curve;
    const Result result = VFC::fill(curve, box, np::thickness(1).random_seed(seed));
    EXPECT_EQ(result.status, Filling_status::CONVERGED) << seed;
    expect_shape(curve, 0.85, 1.6);
  }
}

TEST(Fill_round, is_the_default_but_not_for_a_preview)
{
  const Box wide({0, 0, 0}, {7, 7, 7});
  Curve round, quick;
  VFC::fill(round, wide, np::thickness(1));
  expect_shape(round, 0.85, 1.6);
  const Result result = VFC::fill(quick, wide, preview(1));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  EXPECT_LT(result.min_bend_radius, 0.5);
  EXPECT_TRUE(result.shape_excesses.empty());
}

// While it bends, the flow has a smaller thickness than the filling.
TEST(Fill_round, reports_its_thickness_if_it_ends_while_it_bends)
{
  Curve curve;
  const Result result = VFC::fill(curve, box, np::thickness([](const Point& p) {
                                                return 1 + p.x() / 6;
                                              }).number_of_iterations(8));
  EXPECT_EQ(result.status, Filling_status::LIMIT);
  EXPECT_GT(result.thickness, 1);
  EXPECT_LT(result.thickness, 2);
}

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

TEST(Fill_round, keeps_a_strand_distance_in_a_ball)
{
  const VFC::Ball_domain_3<Kernel> ball({0, 0, 0}, 4);
  Curve curve;
  const Result result = VFC::fill(curve, ball, np::thickness(1).strand_distance(1.7));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  expect_shape(curve, 0.85, 1.7);
  expect_inside(curve, ball);
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

using Plate = VFC::Polygon_domain_3<Traits>;

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

// A plate with two holes is filled as in space, and z stays 0.
TEST(Fill_round, stays_in_the_plane)
{
  const Plate plate(polygons::plate());
  for(const double r : {0.08, 0.04}) {
    Curve curve;
    const Result result = VFC::fill(curve, plate, np::thickness(r));
    EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
    for(const Point& p : curve.points()) EXPECT_EQ(p.z(), 0);
    expect_shape(curve, 0.85 * r, 1.6 * r);
    expect_inside(curve, plate);
    EXPECT_GE(coverage(curve, plate, r).fraction_within_r, 0.93);
  }
}

// Pinned nodes make a neck straight: each lies on a segment from the wall to the end of a neck.
void expect_straight_necks(const Curve& curve, const Result& result)
{
  using VFC::internal::to_vector;
  using VFC::internal::Vector;
  for(const std::size_t v : curve.nodes()) {
    if(!curve.is_pinned(v)) continue;
    double least = std::numeric_limits<double>::infinity();
    for(const auto& neck : result.necks) {
      const Vector wall = to_vector(neck.wall);
      const Vector u(neck.direction[0], neck.direction[1], neck.direction[2]);
      const Vector x = to_vector(curve.point(v));
      least = (std::min)(
          least, VFC::internal::squared_distance_to_segment(x, wall, wall + neck.length * u));
    }
    EXPECT_LE(least, 1e-18);
  }
}

template <typename Domain>
void expect_round_between_ports(const Domain& domain,
                                double r,
                                const std::vector<VFC::Port<Point>>& ports,
                                double fraction_within_r)
{
  Curve curve;
  const Result result = VFC::fill(curve, domain, np::thickness(r).ports(ports));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  ASSERT_EQ(result.necks.size(), ports.size());
  for(const auto& neck : result.necks) EXPECT_NEAR(neck.length, r, 1e-9);
  expect_straight_necks(curve, result);
  expect_shape(curve, 0.85 * r, 1.6 * r);
  expect_inside(curve, domain);
  EXPECT_GE(coverage(curve, domain, r).fraction_within_r, fraction_within_r);
}

// The corner at the end of a neck kept a radius of 0.2 r, and the curve shrank by half meanwhile.
TEST(Fill_round, bends_behind_the_necks_of_ports)
{
  const VFC::Ball_domain_3<Kernel> ball({0, 0, 0}, 1);
  expect_round_between_ports(ball, 0.2, {{Point(-0.6, 0.8, 0)}, {Point(0, 0, 1.01)}}, 0.75);
  expect_round_between_ports(Plate(polygons::plate()), 0.08,
                             {{Point(-1.5, 0, 0)}, {Point(0.2, 1, 0)}}, 0.9);
}

// The arcs between two ports of this box jam with a few seeds.
const Box box_of_arcs({0, 0, 0}, {8, 8, 8});
const std::vector<VFC::Port<Point>> two_ports = {{Point(0, 4, 4)}, {Point(8, 4, 4)}};
constexpr std::size_t iterations_to_jam = 42; // to open, to bend, and to polish in vain

TEST(Long_fill_round, loosens_arcs_that_jam)
{
  for(const std::size_t seed : {0u, 19u, 21u}) { // once, once, twice
    Curve curve;
    const Result result =
        VFC::fill(curve, box_of_arcs, np::thickness(1).random_seed(seed).ports(two_ports));
    EXPECT_GT(result.statistics.iterations, iterations_to_jam) << seed;
    EXPECT_EQ(result.status, Filling_status::CONVERGED) << seed;
    expect_shape(curve, 0.85, 1.6);
  }
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

// Nodes that the guard held at that distance held bends of 0.3 r next to them.
TEST(Fill_round, keeps_a_distance_from_the_boundary)
{
  const Box cube({0, 0, 0}, {1, 1, 1});
  const double r = 0.1;
  Curve curve;
  const Result result = VFC::fill(curve, cube, np::thickness(r).wall_distance(r));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  EXPECT_GE(result.min_wall_distance, r);
  expect_shape(curve, 0.85 * r, 1.6 * r);
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
  VFC::internal::Filling_state state;
  const Flow::Thickness thickness(1);
  VFC::internal::Filling_stage_runner<Flow, VFC::Default_curve_flow_visitor> runner(
      guard, parameters, thickness, watch, visitor, state);
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

TEST(Fill_round, is_the_same_in_parallel_and_at_another_scale)
{
  const auto fill_box = [](auto tag, double unit) {
    Curve curve;
    const Box scaled({0, 0, 0}, {4 * unit, 4 * unit, 4 * unit});
    VFC::fill<decltype(tag)>(curve, scaled, np::thickness(unit).bend_radius(0.85 * unit));
    std::vector<Point> result;
    for(const Point& p : curve.points())
      result.emplace_back(p.x() / unit, p.y() / unit, p.z() / unit);
    return result;
  };
  const std::vector<Point> once = fill_box(CGAL::Sequential_tag(), 1);
  EXPECT_EQ(once, fill_box(CGAL::Parallel_if_available_tag(), 1));
  EXPECT_EQ(once, fill_box(CGAL::Sequential_tag(), 0x1p+20));
}

} // namespace test_fill_round
