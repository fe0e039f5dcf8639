// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/domain_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/domain/Inset_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

// What is farther than c from the boundary, as a domain, and as a limit of a guard.
namespace test_inset_domain {

using namespace domain_test;
using Network = Curve_network_3<>;
using Ball = Ball_domain_3<>;
using Box = Box_domain_3<>;
using internal::Vector;

static_assert(internal::check_domain<Inset_domain_3<Mesh_domain>, Point>());
static_assert(internal::Is_scalable<Inset_domain_3<Mesh_domain>>::value);

// The least distance of points spread evenly over a triangle.
double sampled_depth(const Mesh_domain& domain, const Point& p, const Point& q, const Point& r)
{
  constexpr int n = 24;
  double least = infinity;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; i + j <= n; ++j)
      least = (std::min)(least, domain.distance(p + (q - p) * i / n + (r - p) * j / n));
  return least;
}

TEST(Inset, holds_a_triangle_only_if_all_of_it_is_deep_enough)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::sphere(1, 2)));
  Random random(1);
  for(const double c : {0.05, 0.2, 0.5}) {
    const Inset_domain_3 inset(domain, c);
    std::size_t held = 0, refused = 0;
    for(int k = 0; k < 2000; ++k) {
      const double size = k % 2 == 0 ? 0.05 : 0.5;
      const Point p = random_point(random, domain.bbox());
      const auto near_p = [&] {
        const Point q = random_point(random, domain.bbox());
        return p + size * (q - CGAL::ORIGIN);
      };
      const Point q = near_p(), r = k % 3 == 0 ? q : near_p();
      if(!inset.is_inside(p)) continue;
      const bool is_inside = inset.is_triangle_inside(p, q, r);
      const double depth = domain.is_triangle_inside(p, q, r) ? sampled_depth(domain, p, q, r) : 0;
      const double longest =
          std::sqrt((std::max)({CGAL::squared_distance(p, q), CGAL::squared_distance(q, r),
                                CGAL::squared_distance(r, p)}));
      if(is_inside) {
        EXPECT_GT(depth, c);
      }
      // in doubt near the limit only; the samples are longest / 24 apart
      if(depth > c + longest / 64 + longest / 24) {
        EXPECT_TRUE(is_inside);
      }
      ++(is_inside ? held : refused);
    }
    EXPECT_GT(held, 20u);
    EXPECT_GT(refused, 20u);
  }
}

// Far from the origin, points halfway between others are rounded by 1e-8.
TEST(Inset, holds_no_triangle_that_is_too_near_wherever_the_domain_lies)
{
  constexpr double far_away = 1e8, c = 0.25;
  const auto at = [](double x, double y, double z) {
    return Point(far_away + x, far_away + y, far_away + z);
  };
  const Box box(at(0, 0, 0), at(1, 1, 1));
  const Inset_domain_3 inset(box, c);
  const double unit = std::nextafter(far_away, 2 * far_away) - far_away;
  EXPECT_TRUE(inset.is_triangle_inside(at(0.5, 0.5, 0.5), at(0.75 - 16 * unit, 0.5, 0.5),
                                       at(0.5, 0.6, 0.5)));
  for(int k = 0; k < 4; ++k) {
    const Point q = at(0.75 + k * unit, 0.5 + k * unit, 0.5);
    EXPECT_FALSE(inset.is_triangle_inside(at(0.5, 0.5, 0.5), q, q)) << k;
  }
}

TEST(Inset, is_a_smaller_ball_or_box)
{
  const Ball ball(Point(0, 0, 0), 1);
  const Inset_domain_3 inset(ball, 0.25);
  EXPECT_TRUE(inset.is_inside(Point(0.74, 0, 0)));
  EXPECT_FALSE(inset.is_inside(Point(0.76, 0, 0)));
  EXPECT_FALSE(inset.is_inside(Point(2, 0, 0)));
  EXPECT_NEAR(inset.distance(Point(0, 0.5, 0)), 0.25, 1e-9);
  EXPECT_NEAR(inset.distance_along(Point(0, 0, 0), Ball::Vector_3(1, 0, 0), 2), 0.75, 1e-2);
  EXPECT_EQ(inset.distance_along(Point(0, 0, 0), Ball::Vector_3(1, 0, 0), 0.5), 0.5);
  const Inset_domain_3 box(Box(Point(0, 0, 0), Point(1, 2, 3)), 0.125);
  EXPECT_EQ(box.bbox(), CGAL::Bbox_3(0.125, 0.125, 0.125, 0.875, 1.875, 2.875));
  const auto scaled = box.scaled(4);
  EXPECT_EQ(scaled.wall_distance(), 0.5);
  EXPECT_TRUE(scaled.is_inside(Point(0.51, 4, 4)));
  EXPECT_FALSE(scaled.is_inside(Point(0.49, 4, 4)));
}

TEST(Inset, of_a_planar_domain_is_planar)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Polygon_2<Kernel> square;
  for(const auto& [x, y] : {std::pair(0, 0), {4, 0}, {4, 4}, {0, 4}})
    square.push_back(Kernel::Point_2(x, y));
  const Inset_domain_3 inset(Polygon_domain_3<>(square), 1);
  EXPECT_EQ(internal::dimension_of<decltype(inset)>, 2);
  EXPECT_EQ(inset.bbox(), CGAL::Bbox_3(1, 1, 0, 3, 3, 0));
  EXPECT_TRUE(inset.is_inside(Point(1.1, 2, 0)));
  EXPECT_FALSE(inset.is_inside(Point(0.9, 2, 0)));
  EXPECT_FALSE(inset.is_inside(Point(2, 2, 0.1)));
  EXPECT_TRUE(inset.is_triangle_inside(Point(1.1, 2, 0), Point(2.9, 2, 0), Point(2, 2.9, 0)));
  EXPECT_FALSE(inset.is_triangle_inside(Point(1.1, 2, 0), Point(2.9, 2, 0), Point(2, 3.1, 0)));
  EXPECT_THROW(Inset_domain_3(Polygon_domain_3<>(square), 2), std::invalid_argument);
}

TEST(Inset, is_refused_if_the_distance_is_none_or_leaves_nothing)
{
  const Box box(Point(0, 0, 0), Point(1, 2, 3));
  for(const double c : {-1., 0.5, 7., infinity, std::nan("")})
    EXPECT_THROW(Inset_domain_3(box, c), std::invalid_argument) << c;
}

Network ring_in_ball()
{
  std::vector<Point> points;
  for(int k = 0; k <= 30; ++k)
    points.emplace_back(0.7 * std::cos(k % 30 * 0.2 * 1.0471975511965976),
                        0.7 * std::sin(k % 30 * 0.2 * 1.0471975511965976), 0);
  return Network(std::vector<std::vector<Point>>{points});
}

TEST(Wall_distance_of_a_guard, refuses_a_move_a_split_and_a_motion_that_come_nearer)
{
  const Ball ball(Point(0, 0, 0), 1);
  for(const bool is_set : {false, true}) {
    Network curve = ring_in_ball();
    Isotopy_guard_3<Curve_flow_traits_3<>, Ball> guard(curve, ball);
    if(is_set) guard.set_wall_distance(0.25);
    EXPECT_TRUE(guard.move_node(0, Point(0.74, 0, 0)));
    EXPECT_EQ(guard.move_node(0, Point(0.76, 0, 0)), !is_set);
    const Point p = CGAL::midpoint(curve.point(7), curve.point(8));
    EXPECT_EQ(guard.insert_node(7, CGAL::ORIGIN + 0.8 / 0.69 * (p - CGAL::ORIGIN)), !is_set);
    guard.collect_garbage(); // motions ask for that
    internal::Vector_field targets = internal::coordinates(curve);
    targets *= 1.2;
    EXPECT_EQ(guard.move_nodes(targets) == 1, !is_set);
  }
}

TEST(Wall_distance_of_a_guard, holds_in_motions_along_a_mesh)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::sphere(1, 2)));
  Network curve = ring_in_ball();
  Isotopy_guard_3<Curve_flow_traits_3<>, Mesh_domain> guard(curve, domain);
  guard.set_wall_distance(0.2);
  Random random(2);
  for(int k = 0; k < 40; ++k) {
    internal::Vector_field targets = internal::coordinates(curve);
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
      const double x = random.real() - 0.5, y = random.real() - 0.5, z = random.real() - 0.5;
      internal::set_row(targets, v, 1.02 * internal::row(targets, v) + 0.1 * Vector(x, y, z));
    }
    guard.advance_nodes(targets);
    ASSERT_GE(min_wall_distance(curve, domain).distance, 0.2) << k;
  }
  EXPECT_LT(min_wall_distance(curve, domain).distance, 0.21); // as near as it may
}

} // namespace test_inset_domain
