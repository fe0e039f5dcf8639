// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_round_test_support.h"
#include "support/polygon_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

// Fillings keep a bend radius and a distance between strands. All is measured anew.
namespace test_fill_round {

using namespace fill_round_test;

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

TEST(Fill_round, keeps_a_strand_distance_in_a_ball)
{
  const VFC::Ball_domain_3<Kernel> ball({0, 0, 0}, 4);
  Curve curve;
  const Result result = VFC::fill(curve, ball, np::thickness(1).strand_distance(1.7));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  expect_shape(curve, 0.85, 1.7);
  expect_inside(curve, ball);
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

// The arcs between two ports of this box jam with 8 of the seeds 0 to 149.
const Box box_of_arcs({0, 0, 0}, {8, 8, 8});
const std::vector<VFC::Port<Point>> two_ports = {{Point(0, 4, 4)}, {Point(8, 4, 4)}};
constexpr std::size_t iterations_to_jam = 38; // to open, to bend, and to polish in vain

TEST(Long_fill_round, loosens_arcs_that_jam)
{
  for(const std::size_t seed : {11u, 21u, 129u}) {
    Curve curve;
    const Result result =
        VFC::fill(curve, box_of_arcs, np::thickness(1).random_seed(seed).ports(two_ports));
    EXPECT_GT(result.statistics.iterations, iterations_to_jam) << seed;
    EXPECT_EQ(result.status, Filling_status::CONVERGED) << seed;
    expect_shape(curve, 0.85, 1.6);
  }
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
