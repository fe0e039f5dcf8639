// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/domain_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// The least distance of a curve to the boundary, over whole edges.
namespace test_least_depth {

using namespace domain_test;
using Network = Curve_network_3<>;

// A domain that knows the distances of points only.
struct Points_only
{
  using Point_3 = Mesh_domain::Point_3;
  using Vector_3 = Mesh_domain::Vector_3;

  const Mesh_domain& domain;

  CGAL::Bbox_3 bbox() const { return domain.bbox(); }
  bool is_inside(const Point& p) const { return domain.is_inside(p); }
  bool is_triangle_inside(const Point& p, const Point& q, const Point& r) const
  {
    return domain.is_triangle_inside(p, q, r);
  }
  double distance(const Point& p) const { return domain.distance(p); }
  double distance_along(const Point& p, const Vector_3& u, double limit) const
  {
    return domain.distance_along(p, u, limit);
  }
};

Network segments(const std::vector<Point>& points)
{
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t i = 1; i < points.size(); i += 2) edges.push_back({i - 1, i});
  return Network(points, edges);
}

// Random segments inside.
Network random_segments(const Mesh_domain& domain, std::size_t number, std::size_t seed)
{
  Random random(seed);
  std::vector<Point> points;
  while(points.size() < 2 * number) {
    const Point p = random_point(random, domain.bbox()), q = random_point(random, domain.bbox());
    if(domain.is_inside(p) && domain.is_triangle_inside(p, q, q))
      points.insert(points.end(), {p, q});
  }
  return segments(points);
}

// The least distance of points spread evenly along all edges, and the largest step between them.
std::array<double, 2> sampled(const Network& curve, const Mesh_domain& domain)
{
  constexpr std::size_t n = 400;
  double least = infinity, longest = 0;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const Point &p = curve.point(curve.source(e)), &q = curve.point(curve.target(e));
    longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(p, q)) / n);
    for(std::size_t k = 0; k <= n; ++k)
      least = (std::min)(least, domain.distance(p + static_cast<double>(k) / n * (q - p)));
  }
  return {least, longest};
}

TEST(Wall_distance, is_that_of_the_inside_of_an_edge)
{
  // a ridge whose top at (2, ., 1) points into the domain from below
  const Mesh_domain domain(
      meshes::to_mesh(meshes::voxels({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}})));
  const Network curve = segments(
      {Point(0.5, 0.5, 0.75), Point(2.5, 0.5, 0.75), Point(0.5, 0.5, 1.5), Point(0.5, 0.4, 1.6)});
  const auto nearest = min_wall_distance(curve, domain);
  EXPECT_DOUBLE_EQ(nearest.distance, 0.25);
  EXPECT_EQ(nearest.edge, 0u);
  EXPECT_GE(nearest.point.x(), 1 - 1e-12);
  EXPECT_LE(nearest.point.x(), 2 + 1e-12);
}

TEST(Wall_distance, is_no_larger_than_that_of_any_point_and_is_attained)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::sphere(1, 2)));
  for(const std::size_t seed : {1u, 2u, 3u, 4u, 5u}) {
    const Network curve = random_segments(domain, 200, seed);
    const auto nearest = min_wall_distance(curve, domain);
    const auto [least, step] = sampled(curve, domain);
    EXPECT_LE(nearest.distance, least * (1 + 1e-12));
    EXPECT_GE(nearest.distance, least - step);
    EXPECT_NEAR(domain.distance(nearest.point), nearest.distance, 1e-12);
    const auto parallel = min_wall_distance<CGAL::Parallel_if_available_tag>(curve, domain);
    EXPECT_EQ(parallel.distance, nearest.distance);
    EXPECT_EQ(parallel.edge, nearest.edge);
    EXPECT_EQ(parallel.point, nearest.point);
  }
}

TEST(Wall_distance, is_nearly_the_same_if_a_domain_knows_points_only)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::sphere(1, 2)));
  for(const std::size_t seed : {1u, 2u, 3u}) {
    const Network curve = random_segments(domain, 200, seed);
    const double exact = min_wall_distance(curve, domain).distance;
    const double found = min_wall_distance(curve, Points_only{domain}).distance;
    EXPECT_GE(found, exact * (1 - 1e-12));
    EXPECT_LE(found, exact + 1e-3);
  }
}

TEST(Wall_distance, is_exact_in_a_ball_and_a_box)
{
  const Network curve =
      segments({Point(0, 0, 0), Point(0.25, 0, 0), Point(0, 0, 0), Point(0, 0.75, 0)});
  EXPECT_DOUBLE_EQ(min_wall_distance(curve, Ball_domain_3<>(Point(0, 0, 0), 1)).distance, 0.25);
  const auto nearest = min_wall_distance(curve, Box_domain_3<>(Point(-1, -2, -1), Point(1, 1, 1)));
  EXPECT_DOUBLE_EQ(nearest.distance, 0.25);
  EXPECT_EQ(nearest.edge, 1u);
  EXPECT_EQ(nearest.point, Point(0, 0.75, 0));
}

struct One_number : Points_only
{
  double distance(const Point& p) const { return p.x() == 0.25 ? 0.5 : std::nan(""); }
};

TEST(Wall_distance, ends_if_distances_are_no_numbers)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::sphere(1, 2)));
  const auto nearest =
      min_wall_distance(segments({Point(0, 0, 0), Point(0.5, 0, 0)}), One_number{{domain}});
  EXPECT_EQ(nearest.edge, 0u);
}

TEST(Wall_distance, of_nothing_is_infinite)
{
  const auto nearest = min_wall_distance(Network(), Ball_domain_3<>(Point(0, 0, 0), 1));
  EXPECT_EQ(nearest.distance, infinity);
  EXPECT_EQ(nearest.edge, static_cast<std::size_t>(-1));
}

} // namespace test_least_depth
