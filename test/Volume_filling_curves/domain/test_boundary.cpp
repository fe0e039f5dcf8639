// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

// Queries of the flow to the boundary of a domain, against brute force and closed forms.
namespace test_boundary {

using namespace exact_surface;
using namespace CGAL::Volume_filling_curves;
using internal::Vector;
using Mesh_domain = Triangle_mesh_domain_3<>;
using Ball = Ball_domain_3<>;
using Box = Box_domain_3<>;
using Random = std::mt19937;

template <typename Domain>
using Boundary = internal::Boundary<Domain>;

double between(double low, double high, Random& random)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vector random_vector(Random& random)
{
  const double x = between(-1, 1, random), y = between(-1, 1, random);
  return {x, y, between(-1, 1, random)};
}

Point to_point(const Vector& x)
{
  return {x.x(), x.y(), x.z()};
}

template <typename Domain>
std::vector<Point> points_inside(const Domain& domain, std::size_t n, Random& random)
{
  const CGAL::Bbox_3 box = domain.bbox();
  std::vector<Point> points;
  while(points.size() < n) {
    const double x = between(box.xmin(), box.xmax(), random),
                 y = between(box.ymin(), box.ymax(), random);
    const Point p(x, y, between(box.zmin(), box.zmax(), random));
    if(domain.is_inside(p)) points.push_back(p);
  }
  return points;
}

Soup shifted(Soup soup, double shift)
{
  for(Point& p : soup.points) p = {p.x() + shift, p.y() - shift, p.z() + 2 * shift};
  return soup;
}

std::vector<Soup> some_soups()
{
  const Soup hollow = meshes::sphere(2, 1) + meshes::sphere(0.5, 1).inverted();
  const Soup plate = stretched(meshes::cube(), 2, {0, 1e-3});
  return {meshes::cube(), corner_piece(), two_legs(1e-3), hollow, plate, shifted(hollow, 1e6)};
}

TEST(Boundary, never_claims_more_clearance_than_there_is)
{
  Random random(1);
  for(const Soup& soup : some_soups()) {
    const Mesh_domain domain(meshes::to_mesh(soup));
    const Boundary<Mesh_domain> walls(domain);
    const Surface surface(soup);
    const CGAL::Bbox_3 box = domain.bbox();
    const double size = (std::max)({box.x_span(), box.y_span(), box.z_span()});
    for(const Point& p : points_inside(domain, 300, random)) {
      const double distance = surface.distance(p);
      for(const double needed : {0., 1e-3 * size, 0.05 * size, 0.5 * distance, 10 * size}) {
        const double clearance = walls.clearance(p, needed);
        EXPECT_LT(clearance, distance);
        if(clearance <= needed) {
          EXPECT_NEAR(clearance, distance, 1e-8 * size);
        }
      }
    }
  }
}

TEST(Boundary, knows_a_lower_bound_of_what_an_implicit_domain_knows)
{
  Random random(2);
  const auto torus = [](const Point& p) { // the distance to its surface, negative inside
    return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.4;
  };
  const Implicit_domain_3<decltype(torus)> domain(torus, CGAL::Bbox_3(-2, -2, -1, 2, 2, 1));
  const Boundary<Implicit_domain_3<decltype(torus)>> walls(domain);
  for(const Point& p : points_inside(domain, 1000, random)) {
    EXPECT_LT(walls.clearance(p, between(0, 0.5, random)), -torus(p));
    const Vector x = internal::to_vector(p), y = x + 0.2 * random_vector(random),
                 z = x + 0.2 * random_vector(random);
    const bool is_inside = walls.is_triangle_inside(p, to_point(y), to_point(z));
    if(domain.is_triangle_inside(p, to_point(y), to_point(z))) {
      EXPECT_TRUE(is_inside);
    }
    for(int i = 0; i <= 8 && is_inside; ++i)
      for(int j = 0; j <= 8 - i; ++j)
        EXPECT_LT(torus(to_point(x + i * (y - x) / 8 + j * (z - x) / 8)), 0);
  }
}

// A corner near p, or one of a coarse lattice, on which many faces of the meshes lie.
Point other_corner(const Point& p, Random& random)
{
  const double scale = std::ldexp(1, -static_cast<int>(random() % 12));
  Vector x = internal::to_vector(p) + scale * random_vector(random);
  if(random() % 3 == 0)
    x = internal::Vector(std::round(2 * x.x()), std::round(2 * x.y()), std::round(2 * x.z())) / 2;
  if(random() % 8 == 0) x = internal::to_vector(p);
  return to_point(x);
}

TEST(Boundary, keeps_triangles_inside_exactly_where_the_mesh_does)
{
  Random random(3);
  for(const Soup& soup : some_soups()) {
    const Mesh_domain domain(meshes::to_mesh(soup));
    const Boundary<Mesh_domain> walls(domain);
    const Surface surface(soup);
    int number_of_inside = 0;
    for(const Point& p : points_inside(domain, 150, random)) {
      const Point q = other_corner(p, random), r = other_corner(p, random);
      const bool is_inside = walls.is_triangle_inside(p, q, r);
      number_of_inside += is_inside;
      EXPECT_EQ(is_inside, domain.is_triangle_inside(p, q, r));
      EXPECT_EQ(is_inside, !surface.does_meet({p, q, r}));
    }
    EXPECT_GT(number_of_inside, 5);
    EXPECT_LT(number_of_inside, 145);
  }
}

TEST(Boundary, keeps_triangles_inside_balls_and_boxes)
{
  Random random(4);
  const Ball ball(Point(1, 2, 3), 1.5);
  const Box box(Point(-1, 0, 1), Point(1, 1, 1.25));
  const auto expect_convex = [&](const auto& domain) {
    const Boundary<std::decay_t<decltype(domain)>> walls(domain);
    for(const Point& p : points_inside(domain, 2000, random)) {
      const Point q = other_corner(p, random), r = other_corner(p, random);
      EXPECT_EQ(walls.is_triangle_inside(p, q, r), domain.is_inside(q) && domain.is_inside(r));
    }
  };
  expect_convex(ball);
  expect_convex(box);
}

// Touching is not inside, however little is missing.
TEST(Boundary, counts_the_boundary_as_outside)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::cube()));
  const Boundary<Mesh_domain> walls(domain);
  const Point p(0.5, 0.5, 0.5), q(0.25, 0.5, 0.5);
  EXPECT_FALSE(walls.is_triangle_inside(p, q, Point(0.5, 0.5, 1)));
  EXPECT_FALSE(walls.is_triangle_inside(p, q, Point(1, 1, 1)));
  EXPECT_TRUE(walls.is_triangle_inside(p, q, Point(0.5, 0.5, std::nextafter(1., 0.))));
  EXPECT_TRUE(walls.is_triangle_inside(p, q, Point(0.5, 0.5, 1e-300)));
  EXPECT_FALSE(walls.is_triangle_inside(p, q, Point(0.5, 0.5, -1e-300)));
}

// Bounds are kept from one question to the next; that must not show.
TEST(Boundary, answers_alike_in_any_order_and_in_parallel)
{
  Random random(5);
  const Mesh_domain domain(meshes::to_mesh(two_legs(0.1)));
  const std::vector<Point> points = points_inside(domain, 2000, random);
  const auto needed = [](std::size_t k) { return 0.001 * static_cast<double>(k % 300); };
  const Boundary<Mesh_domain> forward(domain), backward(domain), parallel(domain);
  std::vector<double> expected(points.size()), reversed = expected, concurrent = expected;
  for(std::size_t k = 0; k < points.size(); ++k)
    expected[k] = forward.clearance(points[k], needed(k));
  for(std::size_t k = points.size(); k-- > 0;)
    reversed[k] = backward.clearance(points[k], needed(k));
  std::vector<std::thread> threads;
  for(std::size_t t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for(std::size_t k = t; k < points.size(); k += 4)
        concurrent[k] = parallel.clearance(points[k], needed(k));
    });
  for(std::thread& thread : threads) thread.join();
  EXPECT_EQ(reversed, expected);
  EXPECT_EQ(concurrent, expected);
}

TEST(Boundary, scales_with_the_domain_by_powers_of_two)
{
  Random random(6);
  const Mesh_domain domain(meshes::to_mesh(two_legs(0.125)));
  const Boundary<Mesh_domain> walls(domain);
  const std::vector<Point> points = points_inside(domain, 300, random);
  for(const int exponent : {-40, 3, 40}) {
    const double scale = std::ldexp(1., exponent);
    Soup soup = two_legs(0.125);
    for(Point& p : soup.points) p = to_point(scale * internal::to_vector(p));
    const Mesh_domain scaled_domain(meshes::to_mesh(soup));
    const Boundary<Mesh_domain> scaled(scaled_domain);
    for(const Point& p : points)
      EXPECT_EQ(scaled.clearance(to_point(scale * internal::to_vector(p)), 0.1 * scale),
                scale * walls.clearance(p, 0.1));
  }
}

// The spheres are found up to a part of 1e-4 of how deep they lie in the domain; where they meet
// the boundary at an angle near zero with their way to grow, this leaves more room.
double tolerance(double radius, const Vector& direction, const Vector& normal)
{
  return 1.5e-4 * radius * (1 + 1 / (1 + direction.dot(normal)));
}

TEST(Tangent_radius, is_known_in_a_ball)
{
  Random random(7);
  const Vector center(1, 2, 3);
  const Ball ball(to_point(center), 2);
  const Boundary<Ball> walls(ball);
  for(const Point& p : points_inside(ball, 1000, random)) {
    const Vector u = random_vector(random).normalized(), x = internal::to_vector(p) - center;
    const double expected = (4 - x.squaredNorm()) / (2 * (2 + x.dot(u)));
    const Vector normal = (x + expected * u).normalized();
    const double radius = walls.tangent_radius(p, u, 3, Curve_flow_traits_3<>());
    EXPECT_NEAR(radius, expected, tolerance(expected, u, normal));
    EXPECT_EQ(walls.tangent_radius(p, u, 0.9 * expected, Curve_flow_traits_3<>()), 0.9 * expected);
  }
}

TEST(Tangent_radius, is_known_in_a_box)
{
  Random random(8);
  const Vector low(0, 0, 0), high(4, 3, 0.5);
  const Box box(to_point(low), to_point(high));
  const Boundary<Box> walls(box);
  for(const Point& p : points_inside(box, 1000, random)) {
    const Vector u = random_vector(random).normalized(), x = internal::to_vector(p);
    double expected = 1e3;
    Vector normal;
    for(int axis = 0; axis < 3; ++axis)
      for(const double side : {-1., 1.}) {
        const double distance = side > 0 ? high[axis] - x[axis] : x[axis] - low[axis];
        const double radius = distance / (1 + side * u[axis]);
        if(radius >= expected) continue;
        expected = radius;
        normal = Vector();
        normal[axis] = side;
      }
    EXPECT_NEAR(walls.tangent_radius(p, u, 5, Curve_flow_traits_3<>()), expected,
                tolerance(expected, u, normal));
  }
}

TEST(Distance_along, is_limited_and_known_in_a_box)
{
  const Mesh_domain domain(meshes::to_mesh(two_legs(0.125)));
  const Point p(0.5, 2, 0.5);
  using Vector_3 = Mesh_domain::Vector_3;
  EXPECT_NEAR(domain.distance_along(p, Vector_3(1, 0, 0), 10), 0.5, 1e-12);
  EXPECT_NEAR(domain.distance_along(p, Vector_3(0, -1, 0), 10), 2, 1e-12);
  EXPECT_EQ(domain.distance_along(p, Vector_3(0, -1, 0), 1.5), 1.5);
}

} // namespace test_boundary
