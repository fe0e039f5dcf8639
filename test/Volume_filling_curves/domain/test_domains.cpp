// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/archetype_domain.h"
#include "support/archetype_traits.h"
#include "support/domain_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace test_domains {

using namespace domain_test;

template <typename Domain>
void expect_concept(const Domain& domain, const typename Domain::Point_3& inner)
{
  static_assert(std::is_same<decltype(domain.bbox()), CGAL::Bbox_3>::value);
  static_assert(std::is_same<decltype(domain.is_inside(inner)), bool>::value);
  static_assert(
      std::is_same<decltype(domain.is_triangle_inside(inner, inner, inner)), bool>::value);
  static_assert(std::is_same<decltype(domain.distance(inner)), double>::value);
  static_assert(std::is_same<decltype(domain.distance_along(inner, {1, 0, 0}, 1)), double>::value);
  EXPECT_TRUE(domain.is_inside(inner));
  EXPECT_TRUE(domain.is_triangle_inside(inner, inner, inner));
  const double distance = domain.distance(inner);
  EXPECT_GT(distance, 0);
  EXPECT_GE(domain.distance_along(inner, {0, 0, 1}, infinity), distance * (1 - 1e-15));
  EXPECT_EQ(domain.distance_along(inner, {0, 0, 1}, distance / 2), distance / 2);
  const CGAL::Bbox_3 box = domain.bbox();
  EXPECT_LE(box.xmin(), CGAL::to_double(inner.x()));
  EXPECT_GE(box.zmax(), CGAL::to_double(inner.z()));
}

struct Signed_distance_of_ball
{
  double operator()(const Point& p) const
  {
    return std::sqrt(CGAL::squared_distance(p, Point(0, 0, 0))) - 1;
  }
};

TEST(Domain, all_models_have_what_the_concept_asks_for)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_traits = Curve_flow_traits_3<Exact_kernel>;
  const Point p(.25, .25, .25);
  expect_concept(archetypes::Domain<Point>(0), p);
  expect_concept(Unbounded_domain_3<>(), p);
  expect_concept(Ball_domain_3<>(Point(0, 0, 0), 1), p);
  expect_concept(Box_domain_3<>(Point(0, 0, 0), Point(1, 1, 1)), p);
  expect_concept(Implicit_domain_3<Signed_distance_of_ball>({}, {-1, -1, -1, 1, 1, 1}), p);
  expect_concept(Mesh_domain(meshes::to_mesh(meshes::cube())), p);
  expect_concept(Ball_domain_3<Exact_traits>({0, 0, 0}, 1), {.25, .25, .25});
  expect_concept(Box_domain_3<Exact_traits>({0, 0, 0}, {1, 1, 1}), {.25, .25, .25});
  const archetypes::Archetype::Point_3 q(.25, .25, .25, 0);
  expect_concept(Unbounded_domain_3<archetypes::Archetype>(), q);
  expect_concept(Ball_domain_3<archetypes::Archetype>(q, 1), q);
}

TEST(Ball_domain, agrees_with_its_closed_forms)
{
  const Ball_domain_3<> ball(Point(1, 2, 3), 2);
  Random random(8);
  for(int i = 0; i < 1000; ++i) {
    const internal::Vector offset = 2.2 * random.real() * random.direction(),
                           u = random.direction();
    const Point p(1 + offset.x(), 2 + offset.y(), 3 + offset.z());
    const double norm = offset.norm();
    ASSERT_EQ(ball.is_inside(p), norm < 2);
    ASSERT_NEAR(ball.distance(p), (std::max)(2 - norm, 0.), 1e-14);
    const double t = ball.distance_along(p, {u.x(), u.y(), u.z()}, 100);
    if(norm < 2) {
      ASSERT_NEAR((offset + t * u).norm(), 2, 1e-14);
    } else {
      ASSERT_EQ(t, 0);
    }
  }
}

// Squares of lengths underflow or overflow.
TEST(Ball_domain, of_any_size_has_the_distances_of_the_unit_ball)
{
  const Ball_domain_3<> unit(Point(0, 0, 0), 1);
  Random random(9);
  for(const int exponent : {-1060, -700, -550, 520, 1020}) {
    const double factor = std::ldexp(1., exponent);
    const Ball_domain_3<> ball(Point(0, 0, 0), factor);
    const double rounding = exponent < -1000 ? 1e-4 : 0; // of coordinates
    for(int i = 0; i < 100; ++i) {
      const internal::Vector x = 1.1 * random.real() * random.direction(), u = random.direction();
      const Point p(x.x(), x.y(), x.z()), q(factor * x.x(), factor * x.y(), factor * x.z());
      const Curve_flow_traits_3<>::Vector_3 direction(u.x(), u.y(), u.z());
      ASSERT_NEAR(ball.distance(q) / factor, unit.distance(p), rounding);
      ASSERT_NEAR(ball.distance_along(q, direction, infinity) / factor,
                  unit.distance_along(p, direction, infinity), rounding);
    }
  }
}

TEST(Domain, has_no_points_that_are_not_finite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Ball_domain_3<> ball(Point(0, 0, 0), 1);
  const Box_domain_3<> box(Point(-1, -1, -1), Point(1, 1, 1));
  for(const double x : {nan, infinity, -infinity})
    for(const Point& p : {Point(x, 0, 0), Point(0, x, 0), Point(0, 0, x)}) {
      EXPECT_FALSE(ball.is_inside(p));
      EXPECT_EQ(ball.distance(p), 0);
      EXPECT_EQ(ball.distance_along(p, {1, 0, 0}, 9), 0);
      EXPECT_FALSE(box.is_inside(p));
      EXPECT_EQ(box.distance(p), 0);
      EXPECT_EQ(box.distance_along(p, {1, 0, 0}, 9), 0);
    }
  const auto undefined = [](const Point& p) { return p.x() > 0.5 ? std::sqrt(-1.) : -1.; };
  const Implicit_domain_3<decltype(undefined)> domain(undefined, {-1, -1, -1, 1, 1, 1});
  EXPECT_EQ(domain.distance(Point(0.9, 0, 0)), 0);
}

TEST(Ball_domain, decides_exactly_next_to_the_sphere)
{
  // 3^2 + 4^2 + 12^2 = 13^2
  const Ball_domain_3<> ball(Point(0, 0, 0), 13);
  EXPECT_FALSE(ball.is_inside(Point(3, 4, 12)));
  EXPECT_TRUE(ball.is_inside(Point(3, 4, std::nextafter(12, 0))));
  EXPECT_FALSE(ball.is_inside(Point(3, 4, std::nextafter(12, 13))));
  EXPECT_TRUE(ball.is_triangle_inside({0, 0, 0}, {3, 4, std::nextafter(12, 0)}, {-12, 4, 2.5}));
  EXPECT_FALSE(ball.is_triangle_inside({0, 0, 0}, {3, 4, 12}, {0, 0, 0}));
  const Ball_domain_3<> tiny(Point(0, 0, 0), 13e-170);
  EXPECT_TRUE(tiny.is_inside(Point(3e-170, 4e-170, 11e-170)));
  EXPECT_FALSE(tiny.is_inside(Point(3e-170, 4e-170, 13e-170)));
  EXPECT_THROW(Ball_domain_3<>(Point(0, 0, 0), 0), std::invalid_argument);
  EXPECT_THROW(Ball_domain_3<>(Point(0, 0, 0), infinity), std::invalid_argument);
  EXPECT_THROW(Ball_domain_3<>(Point(0, infinity, 0), 1), std::invalid_argument);
}

TEST(Box_domain, agrees_with_the_mesh_of_a_box)
{
  const Box_domain_3<> box(Point(2, 0, 0), Point(0, 2, 2));
  const Mesh_domain mesh(meshes::to_mesh(meshes::cube(2)));
  EXPECT_EQ(box.bbox(), mesh.bbox());
  Random random(9);
  for(int i = 0; i < 1000; ++i) {
    const Point p = random_point(random, {-.1, -.1, -.1, 2.1, 2.1, 2.1});
    const Point q = lattice_point(random, 3), r = random_point(random, box.bbox());
    ASSERT_EQ(box.is_inside(p), mesh.is_inside(p));
    ASSERT_EQ(box.is_inside(q), mesh.is_inside(q));
    if(!box.is_inside(p)) continue;
    ASSERT_EQ(box.is_triangle_inside(p, q, r), mesh.is_triangle_inside(p, q, r));
    ASSERT_EQ(box.is_triangle_inside(p, r, p), mesh.is_triangle_inside(p, r, p));
    ASSERT_NEAR(box.distance(p), mesh.distance(p), 1e-15);
    const internal::Vector u = random.direction();
    ASSERT_NEAR(box.distance_along(p, {u.x(), u.y(), u.z()}, 3),
                mesh.distance_along(p, {u.x(), u.y(), u.z()}, 3), 1e-13);
  }
  EXPECT_THROW(Box_domain_3<>(Point(0, 0, 0), Point(1, 1, 0)), std::invalid_argument);
  EXPECT_THROW(Box_domain_3<>(Point(0, 0, 0), Point(1, infinity, 1)), std::invalid_argument);
}

TEST(Implicit_domain, accepts_only_what_lies_in_the_ball)
{
  const Ball_domain_3<> ball(Point(0, 0, 0), 1);
  const auto squared = [](const Point& p) { return CGAL::squared_distance(p, Point(0, 0, 0)) - 1; };
  const CGAL::Bbox_3 box(-1, -1, -1, 1, 1, 1);
  const Implicit_domain_3<Signed_distance_of_ball> implicit({}, box);
  const Implicit_domain_3<decltype(squared)> steeper(squared, box, 2 * std::sqrt(3.));
  Random random(10);
  int accepted = 0, accepted_steeper = 0, inside = 0;
  for(int i = 0; i < 1000; ++i) {
    const Point p = random_point(random, box), q = random_point(random, box);
    const Point r = p + .1 * (q - p);
    ASSERT_EQ(implicit.is_inside(p), ball.is_inside(p));
    if(!ball.is_inside(p)) continue;
    ASSERT_NEAR(implicit.distance(p), ball.distance(p), 1e-15);
    ASSERT_LE(steeper.distance(p), ball.distance(p));
    const bool is_in_ball = ball.is_triangle_inside(p, q, r);
    inside += is_in_ball;
    accepted += implicit.is_triangle_inside(p, q, r);
    accepted_steeper += steeper.is_triangle_inside(p, q, r);
    ASSERT_LE(implicit.is_triangle_inside(p, q, r), is_in_ball);
    ASSERT_LE(steeper.is_triangle_inside(p, q, r), is_in_ball);
    const internal::Vector u = random.direction();
    for(const double limit : {.3, 5.}) {
      const double t = ball.distance_along(p, {u.x(), u.y(), u.z()}, limit);
      ASSERT_LE(implicit.distance_along(p, {u.x(), u.y(), u.z()}, limit), t + 1e-14);
      ASSERT_GE(implicit.distance_along(p, {u.x(), u.y(), u.z()}, limit), t - .05 * limit);
      ASSERT_LE(steeper.distance_along(p, {u.x(), u.y(), u.z()}, limit), t + 1e-14);
    }
  }
  EXPECT_GT(accepted, .9 * inside);
  EXPECT_GT(accepted_steeper, .8 * inside);
}

TEST(Implicit_domain, decides_at_any_size)
{
  for(const double size : {1e-170, 1., 1e170}) {
    const auto ball = [size](const Point& p) { return std::hypot(p.x(), p.y(), p.z()) - size; };
    const Implicit_domain_3<decltype(ball)> domain(ball, {-size, -size, -size, size, size, size});
    const Point center(0, 0, 0);
    EXPECT_TRUE(domain.is_triangle_inside(center, Point(size / 2, 0, 0), Point(0, size / 2, 0)));
    EXPECT_FALSE(domain.is_triangle_inside(center, Point(2 * size, 0, 0), center));
    const Point left(-0.8 * size, 0, 0), right(0.8 * size, 0, 0); // no ball covers the edge
    EXPECT_TRUE(domain.is_triangle_inside(left, right, right));
  }
}

TEST(Implicit_domain, refuses_a_spike_between_the_corners)
{
  // two balls that overlap a little: the corners lie deep inside, the way is narrow
  const auto two_balls = [](const Point& p) {
    return std::sqrt((std::min)(CGAL::squared_distance(p, Point(-1, 0, 0)),
                                CGAL::squared_distance(p, Point(1, 0, 0)))) -
           1.01;
  };
  const Implicit_domain_3<decltype(two_balls)> domain(two_balls, {-3, -2, -2, 3, 2, 2});
  const Point p(-1, 0, 0), q(1, 0, 0);
  EXPECT_TRUE(domain.is_triangle_inside(p, q, p)) << "through the neck of radius 0.14";
  EXPECT_FALSE(domain.is_triangle_inside(p, q, Point(1, .5, 0)));
  EXPECT_FALSE(domain.is_triangle_inside(Point(-1, .2, 0), Point(1, .2, 0), p));
  EXPECT_THROW(Implicit_domain_3<Signed_distance_of_ball>({}, {-1, -1, -1, 1, 1, 1}, 0),
               std::invalid_argument);
  EXPECT_THROW(Implicit_domain_3<Signed_distance_of_ball>({}, Unbounded_domain_3<>().bbox()),
               std::invalid_argument);
}

} // namespace test_domains
