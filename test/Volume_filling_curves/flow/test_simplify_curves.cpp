// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/simplify_curves.h>

#include "support/cpu_time.h"
#include "support/guard_test_support.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_simplify_curves {

namespace vfc = CGAL::Volume_filling_curves;
namespace params = vfc::parameters;
using vfc::internal::Polygons;
using vfc::internal::to_vector;
using vfc::internal::Vector;
using Network = vfc::Curve_network_3<>;
using Point_3 = Network::Point_3;

// A ring of small waves.
Network coil(std::size_t n)
{
  std::vector<Point_3> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    const double wave = static_cast<double>(n / 40) * t, radius = 3 + std::cos(wave);
    points.emplace_back(radius * std::cos(t), radius * std::sin(t), std::sin(wave));
  }
  return Network(points, vfc::parameters::closure(vfc::Closure::CLOSED));
}

// Whether the guard would remove no node.
bool is_reduced(Network curve)
{
  vfc::Isotopy_guard_3<> guard(curve);
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(guard.remove_node(v)) return false;
  return true;
}

double distance(const Vector& p, const Network& curve)
{
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    least = (std::min)(least, vfc::internal::squared_distance_to_segment(
                                  p, to_vector(curve.point(curve.source(e))),
                                  to_vector(curve.point(curve.target(e)))));
  return std::sqrt(least);
}

// The largest distance of a point of a to b, by samples of the edges.
double distance(const Network& a, const Network& b)
{
  double largest = 0;
  for(std::size_t e = 0; e < a.number_of_edges(); ++e)
    for(double t = 0; t < 1; t += 0.125) {
      const Vector p = to_vector(a.point(a.source(e))), q = to_vector(a.point(a.target(e)));
      largest = (std::max)(largest, distance(p + t * (q - p), b));
    }
  return largest;
}

TEST(Simplify_curves, leaves_a_triangle_of_a_planar_ring)
{
  Polygons ring(1);
  for(int i = 0; i < 100; ++i) ring[0].emplace_back(std::cos(0.0628 * i), std::sin(0.0628 * i), 0);
  Network curve = vfc::internal::closed_network(ring);
  EXPECT_EQ(vfc::simplify_curves(curve), 97u);
  EXPECT_EQ(curve.number_of_nodes(), 3u);
  EXPECT_FALSE(curve.has_garbage());
}

TEST(Simplify_curves, removes_every_node_that_can_be_removed)
{
  for(std::uint64_t seed = 0; seed < 5; ++seed) {
    Network curve = vfc::make_lattice_polygon(400, seed);
    vfc::simplify_curves(curve);
    EXPECT_TRUE(is_reduced(curve)) << "seed " << seed;
  }
}

TEST(Simplify_curves, keeps_small_degenerate_networks_embedded)
{
  guard_test::Random random(3);
  for(int k = 0; k < 500; ++k) {
    const guard_test::Curve start = guard_test::random_curve(4, k % 2 == 0, random);
    Network curve = guard_test::to_network(start);
    std::vector<std::size_t> special;
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      if(curve.degree(v) != 2) special.push_back(curve.origin(v));
    vfc::simplify_curves(curve);
    EXPECT_TRUE(is_embedded(guard_test::to_curve(curve))) << "curve " << k;
    std::vector<std::size_t> kept;
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      if(curve.degree(v) != 2) kept.push_back(curve.origin(v));
    EXPECT_EQ(kept, special) << "curve " << k;
  }
}

TEST(Simplify_curves, drops_the_inside_of_collinear_runs)
{
  Polygons square(1);
  for(int i = 0; i < 40; ++i) square[0].emplace_back(i, 0, 0);
  for(int i = 0; i < 40; ++i) square[0].emplace_back(40, i, 0);
  square[0].emplace_back(40, 40, 0);
  square[0].emplace_back(0, 40, 0);
  Network curve = vfc::internal::closed_network(square);
  vfc::simplify_curves(curve, params::max_distance(0.));
  ASSERT_EQ(curve.number_of_nodes(), 4u);
  EXPECT_EQ(curve.origin(1), 40u);
}

TEST(Simplify_curves, keeps_pinned_nodes_ends_and_positions)
{
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t i = 0; i < 50; ++i) {
    const double t = static_cast<double>(i);
    points.emplace_back(t, std::sin(t), std::cos(2 * t));
    if(i > 0) edges.push_back({i - 1, i});
  }
  Network curve(points, edges);
  curve.set_pinned(20);
  EXPECT_EQ(vfc::simplify_curves(curve), 47u);
  ASSERT_EQ(curve.number_of_nodes(), 3u);
  for(std::size_t v = 0; v < 3; ++v) EXPECT_EQ(curve.point(v), points[curve.origin(v)]);
  EXPECT_EQ(curve.origin(1), 20u);
}

TEST(Simplify_curves, keeps_a_torus_knot_above_its_stick_number)
{
  Network trefoil = vfc::make_torus_knot(3, 2, 200);
  vfc::simplify_curves(trefoil);
  EXPECT_GE(trefoil.number_of_nodes(), 6u);
  Network torus_5_2 = vfc::make_torus_knot(5, 2, 200);
  vfc::simplify_curves(torus_5_2);
  EXPECT_GE(torus_5_2.number_of_nodes(), 8u);
}

TEST(Simplify_curves, stays_within_the_distance_both_ways)
{
  const Network start = coil(800);
  std::size_t last = start.number_of_nodes();
  for(double max_distance : {0.02, 0.1, 0.5, 2.}) {
    Network curve = start;
    vfc::simplify_curves(curve, params::max_distance(max_distance));
    const double margin = 1 + 1e-12;
    EXPECT_LE(distance(start, curve), margin * max_distance);
    EXPECT_LE(distance(curve, start), margin * max_distance);
    EXPECT_LT(curve.number_of_nodes(), last);
    last = curve.number_of_nodes();
  }
}

// Turning back and forth along a line is within 0 of the line, but not in order.
TEST(Simplify_curves, does_not_cut_off_what_turns_back)
{
  Polygons zigzag = {{{0, 0, 0}, {3, 0.01, 0}, {1, 0.02, 0}, {4, 0.03, 0}, {4, 9, 0}, {0, 9, 0}}};
  Network curve = vfc::internal::closed_network(zigzag);
  vfc::simplify_curves(curve, params::max_distance(0.5));
  EXPECT_EQ(curve.number_of_nodes(), 6u);
  vfc::simplify_curves(curve, params::max_distance(2.5));
  EXPECT_EQ(curve.number_of_nodes(), 4u);
}

TEST(Simplify_curves, keeps_a_clearance)
{
  const Network start = vfc::make_torus_knot(3, 2, 300);
  const double before = vfc::min_clearance(start, 0.2);
  Network curve = start;
  vfc::simplify_curves(curve, params::clearance(0.5 * before));
  EXPECT_LT(curve.number_of_nodes(), 100u);
  EXPECT_GE(vfc::min_clearance(curve, 0.), 0.25 * before);
}

TEST(Simplify_curves, does_not_depend_on_powers_of_two)
{
  const auto simplified = [](double scale) {
    Polygons polygons = vfc::internal::torus_knot(5, 3, 500);
    for(auto& p : polygons[0]) p = scale * p;
    Network curve = vfc::internal::closed_network(polygons);
    vfc::simplify_curves(curve, params::max_distance(0.1 * scale));
    std::vector<std::size_t> kept;
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) kept.push_back(curve.origin(v));
    return kept;
  };
  EXPECT_EQ(simplified(1), simplified(0x1p40));
  EXPECT_EQ(simplified(1), simplified(0x1p-40));
}

// The squares of its waves underflow.
TEST(Simplify_curves, stays_within_the_distance_in_tiny_curves)
{
  const auto nodes_of_waves = [](double scale) {
    const double height = 1e-13 * scale;
    std::vector<Point_3> points;
    for(int k = 0; k < 200; ++k) {
      const double x = k;
      points.emplace_back(scale * k / 200, height * std::sin(x), height * std::cos(x * x));
    }
    Network curve(points);
    vfc::simplify_curves(curve, params::max_distance(height));
    return curve.number_of_nodes();
  };
  EXPECT_EQ(nodes_of_waves(0x1p-495), nodes_of_waves(1));
}

TEST(Simplify_curves, refuses_bad_parameters)
{
  Network curve = coil(100);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(vfc::simplify_curves(curve, params::max_distance(-1.)), std::invalid_argument);
  EXPECT_THROW(vfc::simplify_curves(curve, params::max_distance(nan)), std::invalid_argument);
  EXPECT_THROW(vfc::simplify_curves(curve, params::clearance(-1.)), std::invalid_argument);
}

TEST(Simplify_curves, refuses_a_curve_that_meets_itself)
{
  Network curve = vfc::internal::closed_network({{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}});
  EXPECT_THROW(vfc::simplify_curves(curve), std::invalid_argument);
}

// 1.1 seconds in a release; quadratic time would be hours.
TEST(Long_simplify_curves, takes_seconds_for_a_hundred_thousand_nodes)
{
  Network curve = coil(100000);
  EXPECT_LT(cpu_time::of([&] { vfc::simplify_curves(curve); }), 300);
  EXPECT_EQ(curve.number_of_nodes(), 3u);
}

} // namespace test_simplify_curves
