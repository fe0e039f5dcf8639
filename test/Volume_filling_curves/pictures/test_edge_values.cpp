// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/edge_values.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_edge_values {

using namespace vfc;
using Point = Curve::Point_3;

constexpr double pi = 3.14159265358979323846;

// Regular polygons around the z axis at these heights, of radius 1.
Curve rings(std::size_t n, const std::vector<double>& heights)
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(const double z : heights) {
    const std::size_t first = points.size();
    for(std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
      points.emplace_back(std::cos(angle), std::sin(angle), z);
      edges.push_back({first + i, first + (i + 1) % n});
    }
  }
  return Curve(points, edges);
}

TEST(Edge_values, number_the_components)
{
  const Curve curve = rings(10, {0, 1, 2});
  const Edge_values values = edge_values(curve, Coloring::COMPONENT);
  ASSERT_EQ(values.size(), 30u);
  for(std::size_t e = 0; e < values.size(); ++e)
    for(const double value : values[e])
      EXPECT_EQ(value, static_cast<double>(curve.component(curve.source(e))));
}

TEST(Edge_values, are_lengths_from_the_first_node_to_the_end)
{
  const std::size_t n = 12;
  const Curve curve = rings(n, {0, 1});
  const double edge = 2 * std::sin(pi / static_cast<double>(n));
  const Edge_values values = edge_values(curve, Coloring::ARCLENGTH);
  std::size_t starts = 0, ends = 0;
  for(const auto& [source, target] : values) {
    EXPECT_NEAR(target - source, edge, 1e-12);
    starts += source == 0;
    ends += std::abs(target - static_cast<double>(n) * edge) < 1e-12;
  }
  EXPECT_EQ(starts, 2u);
  EXPECT_EQ(ends, 2u);
}

TEST(Edge_values, refuse_lengths_along_a_junction)
{
  const Curve star({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
                   {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_THROW(edge_values(star, Coloring::ARCLENGTH), Usage_error);
  for(const auto& ends : edge_values(star, Coloring::CURVATURE))
    for(const double value : ends) EXPECT_EQ(value, 0);
}

TEST(Edge_values, are_the_curvature_of_the_inscribed_circle)
{
  const std::size_t n = 30;
  for(const auto& ends : edge_values(rings(n, {0}), Coloring::CURVATURE))
    for(const double value : ends)
      EXPECT_NEAR(value, 1 / std::cos(pi / static_cast<double>(n)), 1e-9);
}

// Two rings above each other are tubes that touch at half of the distance.
TEST(Edge_values, are_the_thickness_up_to_the_next_strand)
{
  for(const double distance : {0.1, 0.4}) {
    const Curve curve = rings(200, {0, distance});
    for(const auto& ends : edge_values(curve, Coloring::THICKNESS))
      for(const double value : ends) EXPECT_NEAR(value, distance / 2, 0.02 * distance);
  }
}

// The radius is a mean, of which the thickness is the least.
TEST(Edge_values, are_radii_between_the_thickness_and_its_limit)
{
  namespace generators = CGAL::Volume_filling_curves::internal;
  const Curve curve = generators::closed_network(generators::torus_knot(2, 3, 200));
  const double cap = 2 * CGAL::Volume_filling_curves::default_thickness(curve);
  const Edge_values radii = edge_values(curve, Coloring::RADIUS);
  const Edge_values thicknesses = edge_values(curve, Coloring::THICKNESS);
  for(std::size_t e = 0; e < radii.size(); ++e)
    for(const std::size_t k : {0u, 1u}) {
      EXPECT_GT(thicknesses[e][k], 0);
      EXPECT_LT(thicknesses[e][k], radii[e][k]);
      EXPECT_LE(radii[e][k], cap);
    }
}

} // namespace test_edge_values
