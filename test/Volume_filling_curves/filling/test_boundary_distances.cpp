// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Widest_ball.h>

#include "support/exact_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// How deep samples of a domain lie in it.
namespace test_boundary_distances {

using namespace CGAL::Volume_filling_curves;
using exact_surface::Point;
using Mesh_domain = Triangle_mesh_domain_3<>;

template <typename Domain>
std::vector<Point> points_inside(const Domain& domain)
{
  return Domain_samples_3<Curve_flow_traits_3<>, Domain>(domain, 2000, 1).points();
}

template <typename Domain>
std::vector<double> all_distances(const Domain& domain, const std::vector<Point>& points)
{
  std::vector<double> distances;
  for(const Point& p : points) distances.push_back(domain.distance(p));
  return distances;
}

std::vector<meshes::Soup> some_soups()
{
  return {meshes::sphere(1, 2), exact_surface::two_legs(0.1), meshes::cube(),
          meshes::sphere(2, 1) + meshes::sphere(0.5, 1).inverted()};
}

TEST(Boundary_distances, are_measured_up_to_a_limit)
{
  for(const meshes::Soup& soup : some_soups()) {
    const Mesh_domain domain(meshes::to_mesh(soup));
    const std::vector<Point> points = points_inside(domain);
    const std::vector<double> expected = all_distances(domain, points);
    for(const double limit : {1e-3, 0.1, 0.4, 10.}) {
      const internal::Boundary_distances<Mesh_domain> distances(domain, points, limit);
      for(std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_EQ(distances.up_to_limit()[k], (std::min)(expected[k], limit));
        EXPECT_EQ(distances[k], expected[k]);
      }
    }
  }
}

TEST(Boundary_distances, have_no_limit_where_they_are_cheap)
{
  const Ball_domain_3<> ball(Point(0, 0, 0), 1);
  const std::vector<Point> points = points_inside(ball);
  const internal::Boundary_distances<Ball_domain_3<>> distances(ball, points, 0.1);
  EXPECT_EQ(distances.up_to_limit(), all_distances(ball, points));
}

TEST(Deepest_point, is_the_one_of_all_whatever_the_limit)
{
  for(const meshes::Soup& soup : some_soups()) {
    const Mesh_domain domain(meshes::to_mesh(soup));
    const std::vector<Point> points = points_inside(domain);
    const std::vector<double> expected = all_distances(domain, points);
    const auto most = std::max_element(expected.begin(), expected.end());
    for(const double limit : {1e-3, 0.1, 0.4, 10.}) {
      const internal::Boundary_distances<Mesh_domain> distances(domain, points, limit);
      const internal::Deepest_point<Mesh_domain> deepest(domain, points, distances.up_to_limit(),
                                                         limit);
      EXPECT_EQ(deepest.number(), static_cast<std::size_t>(most - expected.begin()));
      EXPECT_EQ(deepest.distance(), *most);
    }
  }
}

// In the middle of a cube, and as deep beside it.
TEST(Deepest_point, is_the_first_of_several)
{
  const Mesh_domain domain(meshes::to_mesh(exact_surface::stretched(meshes::cube(), 0, {0, 4})));
  const std::vector<Point> points = {{0.25, 0.5, 0.5}, {2, 0.5, 0.5}, {1, 0.5, 0.5}, {2, 0.5, 0.5}};
  const internal::Boundary_distances<Mesh_domain> distances(domain, points, 0.125);
  const internal::Deepest_point<Mesh_domain> deepest(domain, points, distances.up_to_limit(),
                                                     distances.limit());
  EXPECT_EQ(deepest.number(), 1u);
  EXPECT_EQ(deepest.distance(), 0.5);
}

} // namespace test_boundary_distances
