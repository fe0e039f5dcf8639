// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

// Statistics of the medial spheres of each node.
namespace test_medial_radii {

using namespace flow_test;
using namespace CGAL::Volume_filling_curves;

// The lengths of its edges underflow.
TEST(Default_thickness, of_a_curve_smaller_than_any_square_is_none)
{
  std::vector<Network::Point_3> points;
  for(int k = 0; k <= 10; ++k) points.emplace_back(k * 1e-162, 0, 0);
  Network curve(points);
  EXPECT_EQ(default_thickness(curve), 0);
  Isotopy_guard_3<> guard(curve);
  EXPECT_THROW(Curve_flow_3 flow(guard), std::invalid_argument);
}

TEST(Medial_radii, of_a_circle_are_those_of_its_spheres)
{
  const std::vector<double> radii = medial_radii(make_regular_polygon(200, 2), 5, 4);
  ASSERT_EQ(radii.size(), 200u);
  // to the center the sphere of the circle, in all other directions the cap
  for(const double radius : radii) EXPECT_NEAR(radius, (2 + 3 * 5) / 4., 0.01);
}

// Also where a node has several circles.
TEST(Medial_radii, have_the_mean_medial_radius_as_mean)
{
  Random random(2);
  for(const Network& curve :
      {Network(make_torus_knot(2, 3, 120)), junctions_and_ends(60, random)}) {
    const std::vector<double> radii = medial_radii(curve, 1);
    double sum = 0;
    for(const std::size_t e : curve.edges())
      sum += internal::edge_vector(curve, e).norm() *
             (radii[curve.source(e)] + radii[curve.target(e)]) / 2;
    EXPECT_NEAR(sum / length(curve), mean_medial_radius(curve, 1), 1e-12);
  }
}

// Also beside edges whose squares underflow.
TEST(Medial_radii, are_numbers_beside_the_shortest_edges)
{
  for(const double tiny : {1e-160, 1e-170, 1e-300}) {
    const Network closed(std::vector<Network::Point_3>{
        {0, 0, 0}, {tiny, 0, 0}, {tiny, tiny, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}});
    const Network open = path({{0, 0, 0}, {tiny, 0, 0}, {1, 0, 1}, {0, 1, 0}});
    for(const Network& curve : {closed, open}) {
      for(const double radius : medial_radii(curve, 7)) EXPECT_TRUE(radius > 0 && radius <= 7);
      const double mean = mean_medial_radius(curve, 7);
      EXPECT_TRUE(mean > 0 && mean <= 7);
    }
  }
}

// By definition: no other node lies inside of a sphere, and one lies on it.
TEST(Least_medial_radii, are_those_of_the_largest_empty_spheres)
{
  Random random(3);
  const Network curve = junctions_and_ends(60, random);
  const internal::Vector_field x = internal::coordinates(curve);
  constexpr std::size_t directions = 8;
  constexpr double cap = 0.4;
  std::vector<double> expected(curve.number_of_nodes(), cap);
  for(const internal::Node_circle& circle : internal::node_circles(curve, x))
    for(std::size_t l = 0; l < directions; ++l) {
      const double angle = 2 * CGAL_PI * static_cast<double>(l) / directions;
      const Vector direction = std::cos(angle) * circle.u + std::sin(angle) * circle.v;
      for(std::size_t w = 0; w < curve.number_of_nodes(); ++w) {
        const Vector d = internal::row(x, w) - internal::row(x, circle.node);
        if(direction.dot(d) > 0)
          expected[circle.node] =
              (std::min)(expected[circle.node], d.squaredNorm() / (2 * direction.dot(d)));
      }
    }
  const std::vector<double> radii = min_medial_radii(curve, cap, directions);
  ASSERT_EQ(radii.size(), expected.size());
  for(std::size_t v = 0; v < radii.size(); ++v) EXPECT_NEAR(radii[v], expected[v], 1e-12) << v;
}

TEST(Medial_radii, are_the_cap_where_nothing_is_near_and_none_of_nothing)
{
  for(const double radius : medial_radii(path({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}), 7))
    EXPECT_NEAR(radius, 7, 1e-12);
  for(const double radius : min_medial_radii(path({{0, 0, 0}, {1, 0, 0}}), 7)) EXPECT_EQ(radius, 7);
  EXPECT_TRUE(medial_radii(Network(), 7).empty());
  EXPECT_TRUE(min_medial_radii(Network(), 7).empty());
}

TEST(Least_medial_radii, are_at_least_the_thickness_of_the_curve)
{
  const Network knot = make_torus_knot(2, 3, 400);
  const double thickness = polygonal_thickness(knot);
  const std::vector<double> radii = min_medial_radii(knot, 2 * thickness, 64);
  EXPECT_NEAR(*std::min_element(radii.begin(), radii.end()), thickness, 0.01 * thickness);
}

} // namespace test_medial_radii
