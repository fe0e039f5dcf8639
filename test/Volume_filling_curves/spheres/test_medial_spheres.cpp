// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/cpu_time.h"
#include "support/flow_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

// Medial spheres and neighborhoods against their definitions, over all nodes.
namespace test_medial_spheres {

using namespace flow_test;
using internal::Medial_sphere_search;
using internal::Medial_spheres;
using internal::Node_circle;

// 2 x . d / |d|^2, the reciprocal of the radius at which a sphere touches
double support(const Vector& direction, const Vector& d)
{
  return 2 * direction.dot(d) / d.squaredNorm();
}

// the direct formula
double brute_force_radius(const Vector_field& x,
                          const Vector& p,
                          const Vector& direction,
                          double cap)
{
  double most = 1 / cap;
  for(Eigen::Index j = 0; j < x.rows(); ++j) {
    const Vector d = internal::row(x, j) - p;
    if(d.squaredNorm() > 0) most = (std::max)(most, support(direction, d));
  }
  return 1 / most;
}

// the definition: a ball is free if no node lies inside
double bisected_radius(const Vector_field& x, const Vector& p, const Vector& direction, double cap)
{
  const auto is_free = [&](double radius) {
    const Vector center = p + radius * direction;
    for(Eigen::Index j = 0; j < x.rows(); ++j) {
      const Vector q = internal::row(x, j);
      if(q != p && (q - center).norm() < radius * (1 - 1e-13)) return false;
    }
    return true;
  };
  if(is_free(cap)) return cap;
  double low = 0, high = cap;
  for(int k = 0; k < 60; ++k) (is_free((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

void expect_spheres_as_defined(const Medial_spheres& spheres, const Vector_field& x, double cap)
{
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    const Vector p = internal::row(x, spheres.circles()[c].node);
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      const Vector direction = spheres.direction(c, l);
      const double radius = spheres.radius(c, l);
      ASSERT_NEAR(radius, brute_force_radius(x, p, direction, cap), 1e-12 * radius);
      const auto touched = spheres.touching_node(c, l);
      if(touched == Medial_spheres::no_node) {
        ASSERT_EQ(radius, cap);
      } else {
        const Vector d = internal::row(x, touched) - p;
        ASSERT_NEAR(radius * support(direction, d), 1, 1e-12);
      }
    }
  }
}

TEST(Medial_spheres, are_those_of_the_direct_formula)
{
  Random random(1);
  for(std::size_t n : {1u, 2u, 3u, 7u, 16u, 33u})
    for(double cap : {1e-9, 0.05, 0.5, 3., 1e6}) {
      const Network curve = junctions_and_ends(40 + 3 * n, random);
      const Medial_spheres spheres = spheres_of(curve, n, cap);
      EXPECT_EQ(spheres.number_of_directions(), n);
      expect_spheres_as_defined(spheres, internal::coordinates(curve), cap);
    }
}

TEST(Medial_spheres, are_the_largest_that_hold_no_node)
{
  Random random(2);
  const Network curve = junctions_and_ends(60, random);
  const Vector_field x = internal::coordinates(curve);
  const Medial_spheres spheres = spheres_of(curve, 7, 0.8);
  for(std::size_t c = 0; c < spheres.circles().size(); ++c)
    for(std::size_t l = 0; l < 7; ++l) {
      const Vector p = internal::row(x, spheres.circles()[c].node);
      const double expected = bisected_radius(x, p, spheres.direction(c, l), 0.8);
      EXPECT_NEAR(spheres.radius(c, l), expected, 1e-6 * expected);
    }
}

TEST(Medial_spheres, of_long_smooth_curves)
{
  Random random(3);
  Polygon helix;
  for(int k = 0; k < 700; ++k)
    helix.push_back(
        {std::cos(0.1 * k), std::sin(0.1 * k), 0.004 * k + 1e-4 * between(0, 1, random)});
  const Network curve = path(helix);
  for(double cap : {0.1, 0.6, 5.})
    expect_spheres_as_defined(spheres_of(curve, 16, cap), internal::coordinates(curve), cap);
}

TEST(Medial_spheres, touch_nothing_on_a_line)
{
  Polygon line;
  for(int k = 0; k < 100; ++k) line.push_back(k * Vector(0.3, -0.7, 0.2));
  for(double cap : {0.1, 10., 1e5}) {
    const Medial_spheres spheres = spheres_of(path(line), 16, cap);
    for(std::size_t c = 0; c < 100; ++c)
      for(std::size_t l = 0; l < 16; ++l) {
        EXPECT_EQ(spheres.radius(c, l), cap);
        EXPECT_EQ(spheres.touching_node(c, l), Medial_spheres::no_node);
      }
  }
}

// A coincident node is no obstacle; of several obstacles in one place the first is touched.
TEST(Medial_spheres, pass_over_coincident_nodes)
{
  Vector_field x(5, 3);
  x << 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, -0., 0., 0;
  std::vector<Node_circle> circles;
  for(std::size_t v = 0; v < 5; ++v) circles.emplace_back(v, Vector(0, 0, 1), Vector(1, 0, 0), 1.);
  const std::vector<double> thickness(5, 1.);
  const Medial_spheres spheres =
      Medial_sphere_search(CGAL::Sequential_tag(), x, thickness, 10)(circles, 4);
  for(std::size_t v : {0u, 1u, 4u}) {
    EXPECT_EQ(spheres.radius(v, 0), 0.5);
    EXPECT_EQ(spheres.touching_node(v, 0), 2u);
    EXPECT_EQ(spheres.radius(v, 2), 10);
  }
  EXPECT_EQ(spheres.touching_node(3, 2), 0u);
}

void search_heap_of_coincident_nodes(std::size_t n)
{
  Vector_field x = Vector_field::Constant(static_cast<Eigen::Index>(n), 3, 0.3);
  x.row(static_cast<Eigen::Index>(n / 2)) << 0.3, 0.4, 0.3;
  std::vector<Node_circle> circles;
  for(std::size_t v = 0; v < n; ++v) circles.emplace_back(v, Vector(0, 0, 1), Vector(0, 1, 0), 1.);
  const std::vector<double> thickness(n, 1.);
  const Medial_spheres spheres =
      Medial_sphere_search(CGAL::Sequential_tag(), x, thickness, 1)(circles, 16);
  EXPECT_EQ(spheres.touching_node(n - 1, 0), n / 2);
  EXPECT_EQ(spheres.touching_node(n / 2, 8), 0u);
}

// Less than a second; quadratic time would be hours.
TEST(Medial_spheres, of_a_heap_of_coincident_nodes_take_no_time)
{
  EXPECT_LT(cpu_time::of([] { search_heap_of_coincident_nodes(200000); }), 100);
}

TEST(Medial_spheres, are_the_same_bits_in_parallel)
{
#ifdef CGAL_LINKED_WITH_TBB
  Random random(4);
  const Network curve = junctions_and_ends(3000, random);
  const Vector_field x = internal::coordinates(curve);
  const Medial_spheres one = spheres_of(curve, 16, 0.3);
  const std::vector<double> thickness(curve.number_of_nodes(), 1.);
  const Medial_spheres two = Medial_sphere_search(CGAL::Parallel_tag(), x, thickness,
                                                  0.3)(internal::node_circles(curve, x), 16);
  for(std::size_t c = 0; c < one.circles().size(); ++c)
    for(std::size_t l = 0; l < 16; ++l) {
      ASSERT_EQ(one.radius(c, l), two.radius(c, l));
      ASSERT_EQ(one.touching_node(c, l), two.touching_node(c, l));
    }
#else
  GTEST_SKIP() << "TBB is missing";
#endif
}

TEST(Medial_spheres, scale_with_the_curve_by_powers_of_two)
{
  Random random(5);
  const Network curve = junctions_and_ends(300, random);
  const Medial_spheres spheres = spheres_of(curve, 16, 0.3);
  for(int exponent : {-300, -3, 1, 200}) {
    const double scale = std::ldexp(1., exponent);
    const Medial_spheres scaled = spheres_of(transformed(curve, scale), 16, 0.3, scale);
    for(std::size_t c = 0; c < spheres.circles().size(); ++c)
      for(std::size_t l = 0; l < 16; ++l) {
        ASSERT_EQ(scaled.radius(c, l), scale * spheres.radius(c, l));
        ASSERT_EQ(scaled.touching_node(c, l), spheres.touching_node(c, l));
      }
  }
}

TEST(Medial_spheres, turn_with_a_bent_curve)
{
  Random random(6);
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Network curve = internal::closed_network({random_polygon(300, random)});
  const Medial_spheres spheres = spheres_of(curve, 16, 0.3);
  const Medial_spheres turned = spheres_of(transformed(curve, 1, quarter_turn), 16, 0.3);
  std::size_t number_of_bends = 0;
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    if((turned.circles()[c].u - product(quarter_turn, spheres.circles()[c].u)).norm() > 1e-12)
      continue;
    ++number_of_bends; // other circles have an arbitrary first direction
    for(std::size_t l = 0; l < 16; ++l) {
      ASSERT_NEAR(turned.radius(c, l), spheres.radius(c, l), 1e-13);
      ASSERT_EQ(turned.touching_node(c, l), spheres.touching_node(c, l));
    }
  }
  EXPECT_GT(number_of_bends, 200u);
}

// The spheres of one node speed up the search for the next, without an effect on the result: the
// bits are the same in separate queries.
TEST(Medial_spheres, do_not_depend_on_what_else_is_sought)
{
  Random random(8);
  for(double cap : {0.4, 1., 30.}) {
    const Network curve = junctions_and_ends(400, random);
    const Vector_field x = internal::coordinates(curve);
    const std::vector<double> thickness(curve.number_of_nodes(), 0.2);
    const Medial_spheres all = spheres_of(curve, 16, cap, 0.2);
    for(std::size_t c = 0; c < all.circles().size(); ++c) {
      const Medial_spheres one =
          Medial_sphere_search(CGAL::Sequential_tag(), x, thickness, cap)({all.circles()[c]}, 16);
      for(std::size_t l = 0; l < 16; ++l) {
        ASSERT_EQ(one.radius(0, l), all.radius(c, l));
        ASSERT_EQ(one.touching_node(0, l), all.touching_node(c, l));
      }
    }
  }
}

TEST(Node_neighborhoods, are_distinct_nodes_with_all_within_a_distance)
{
  Random random(7);
  for(std::size_t n : {0u, 1u, 19u, 500u}) {
    Vector_field x = random_field(n, random);
    for(Eigen::Index v = 100; v + 3 < x.rows(); v += 3) x.row(v) = x.row(v % 50);
    const internal::Node_neighborhoods neighborhoods(x);
    internal::Node_list found;
    found.push_back(7, Vector(1, 2, 3));
    for(double radius : {0., 0.1, 0.5, 4.}) {
      const Vector center = n > 0 && radius == 0 ? internal::row(x, n / 2) : random_point(random);
      std::multiset<std::size_t> expected;
      for(std::size_t v = 0; v < n; ++v) {
        const auto is_same = [&](std::size_t w) {
          return internal::row(x, w) == internal::row(x, v);
        };
        std::size_t first = 0;
        while(!is_same(first)) ++first;
        if(first == v && (internal::row(x, v) - center).norm() <= radius) expected.insert(v);
      }
      neighborhoods.find(center, radius, found);
      for(std::size_t k = 0; k < found.size(); ++k)
        EXPECT_EQ(Vector(found.x()[k], found.y()[k], found.z()[k]),
                  internal::row(x, found.index(k)));
      found.keep_within(center, radius);
      std::multiset<std::size_t> near;
      for(std::size_t k = 0; k < found.size(); ++k) near.insert(found.index(k));
      EXPECT_EQ(near, expected);
    }
  }
}

} // namespace test_medial_spheres
