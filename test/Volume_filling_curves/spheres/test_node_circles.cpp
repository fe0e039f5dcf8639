// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/medial_radii.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

// The circles of directions at the nodes, the nodes' weights, and the thickness of a curve.
namespace test_node_circles {

using namespace flow_test;
using internal::Node_circle;

std::vector<Node_circle> circles_at(const Network& curve, std::size_t v)
{
  std::vector<Node_circle> circles;
  for(const Node_circle& circle : internal::node_circles(curve, internal::coordinates(curve)))
    if(circle.node == v) circles.push_back(circle);
  return circles;
}

double thickness(const Network& curve)
{
  return CGAL::Volume_filling_curves::default_thickness(curve);
}

TEST(Node_circles, are_orthonormal_and_share_the_weight)
{
  Random random(1);
  const Network curve = junctions_and_ends(300, random);
  const Vector_field x = internal::coordinates(curve);
  std::vector<double> shares(curve.number_of_nodes(), 0.);
  std::size_t last = 0;
  for(const Node_circle& circle : internal::node_circles(curve, x)) {
    EXPECT_GE(circle.node, last);
    last = circle.node;
    shares[circle.node] += circle.share;
    EXPECT_NEAR(circle.u.norm(), 1, 1e-14);
    EXPECT_NEAR(circle.v.norm(), 1, 1e-14);
    EXPECT_NEAR(circle.u.dot(circle.v), 0, 1e-14);
  }
  for(double share : shares) EXPECT_NEAR(share, 1, 1e-14);
}

TEST(Node_circles, inside_a_curve_start_on_the_inside_of_the_bend)
{
  const Network ring = internal::closed_network({circle(24)});
  for(std::size_t v = 0; v < 24; ++v) {
    const auto circles = circles_at(ring, v);
    ASSERT_EQ(circles.size(), 1u);
    EXPECT_NEAR((circles[0].u + internal::to_vector(ring.point(v))).norm(), 0, 1e-12);
    EXPECT_EQ(circles[0].share, 1);
  }
}

TEST(Node_circles, of_ends_junctions_and_spikes_are_one_per_edge)
{
  const Network star =
      network_of({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 1}, {0, 2}, {0, 3}});
  const Network spike = path({{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}});
  for(std::size_t v = 0; v < 4; ++v) {
    const auto circles = circles_at(star, v);
    if(star.degree(v) == 1) {
      ASSERT_EQ(circles.size(), 1u);
      const Vector edge = internal::to_vector(star.point(v)) - Vector();
      EXPECT_NEAR(circles[0].u.dot(edge), 0, 1e-14);
      EXPECT_NEAR(circles[0].v.dot(edge), 0, 1e-14);
    } else {
      ASSERT_EQ(circles.size(), 3u);
      for(const Node_circle& circle : circles) {
        const Vector tangent = circle.u.cross(circle.v); // along an axis
        EXPECT_NEAR(circle.share, std::abs(tangent.dot(Vector(1, 2, 3))) / 6, 1e-14);
      }
    }
  }
  EXPECT_EQ(circles_at(spike, 0).size(), 1u);
  EXPECT_EQ(circles_at(spike, 1).size(), 2u);
}

TEST(Node_weights, are_half_of_the_edges)
{
  const Network star =
      network_of({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 1}, {0, 2}, {0, 3}});
  const auto weights = internal::node_weights(star, internal::coordinates(star));
  for(std::size_t v = 0; v < 4; ++v) {
    const double expected[] = {3, 0.5, 1, 1.5};
    EXPECT_EQ(weights[v], expected[star.origin(v)]);
  }
}

// Of the 16 spheres at a strand next to another one at distance d, the fourth that is longest has
// the radius d / (2 cos 45 degrees).
TEST(Default_thickness, of_a_long_hairpin_follows_from_the_distance_of_its_strands)
{
  Polygon hairpin;
  for(int k = 0; k <= 400; ++k) hairpin.push_back({0.05 * k, 0, 0});
  for(int k = 400; k >= 0; --k) hairpin.push_back({0.05 * k, 0.2, 0});
  EXPECT_NEAR(thickness(internal::closed_network({hairpin})), 0.1 * std::sqrt(2.), 0.01);
}

TEST(Default_thickness, does_not_depend_on_how_the_curve_is_divided)
{
  Polygon coarse, fine;
  for(int k = 0; k < 90; ++k)
    coarse.push_back({std::cos(0.7 * k), std::sin(0.7 * k), 0.05 * k}); // turns 0.45 apart
  for(std::size_t k = 0; k + 1 < coarse.size(); ++k)
    for(int i = 0; i < 8; ++i) fine.push_back(coarse[k] + i / 8. * (coarse[k + 1] - coarse[k]));
  fine.push_back(coarse.back());
  const double expected = thickness(path(coarse));
  EXPECT_NEAR(thickness(path(fine)), expected, 0.05 * expected);
}

TEST(Default_thickness, scales_with_the_curve_by_powers_of_two)
{
  Random random(2);
  const Network curve = internal::closed_network({random_polygon(20, random)});
  const double expected = thickness(curve);
  EXPECT_GT(expected, 0);
  for(int exponent : {-100, 1, 100}) {
    const double scale = std::ldexp(1., exponent);
    EXPECT_EQ(thickness(transformed(curve, scale)), scale * expected);
  }
}

TEST(Default_thickness, of_strands_that_nearly_coincide_needs_no_more_than_some_samples)
{
  const Network needle =
      internal::closed_network({{{0, 0, 0}, {1, 0, 0}, {1, 1e-300, 0}, {0, 1e-16, 0}}});
  EXPECT_NEAR(thickness(needle), 1e-4, 1e-5);
}

TEST(Default_thickness, is_a_part_of_the_extent_at_most)
{
  EXPECT_NEAR(thickness(internal::closed_network({circle(50)})), 0.1 * std::sqrt(8.), 1e-2);
  EXPECT_EQ(thickness(path({{0, 0, 0}, {1, 0, 0}})), 0.1);
  EXPECT_EQ(thickness(Network()), 0);
}

// A sphere at an angle a to the center of a circle of radius 1 has the radius 1 / cos(a).
TEST(Mean_medial_radius, of_a_circle)
{
  using CGAL::Volume_filling_curves::mean_medial_radius;
  const Network ring = internal::closed_network({circle(96)});
  constexpr std::size_t n = 12;
  for(const double cap : {0.5, 1.1, 3.}) {
    double sum = 0;
    for(std::size_t l = 0; l < n; ++l) {
      const double cosine = std::cos(2 * CGAL_PI * static_cast<double>(l) / n);
      sum += cosine > 1 / cap ? 1 / cosine : cap;
    }
    EXPECT_NEAR(mean_medial_radius(ring, cap, n), sum / n, 1e-12);
  }
}

TEST(Mean_medial_radius, is_the_cap_where_nothing_is_near_and_none_of_nothing)
{
  using CGAL::Volume_filling_curves::mean_medial_radius;
  EXPECT_NEAR(mean_medial_radius(path({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}), 7), 7, 1e-12);
  EXPECT_EQ(mean_medial_radius(Network(), 7), 0);
}

} // namespace test_node_circles
