// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Filtered_triangle.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

// The double filters against the exact predicates, where they are most likely to be wrong.
namespace test_filtered_triangle {

using CGAL::Volume_filling_curves::internal::Exact_predicates;
using CGAL::Volume_filling_curves::internal::Filtered_triangle;
using CGAL::Volume_filling_curves::internal::to_point;
using CGAL::Volume_filling_curves::internal::Vector;
using Traits = CGAL::Volume_filling_curves::Curve_flow_traits_3<>;
using Random = std::mt19937;

const Traits traits;

// A point of a small lattice, off it by a few units in the last place, or not.
Vector near_lattice(double scale, Random& random)
{
  Vector p;
  for(int axis = 0; axis < 3; ++axis) {
    double& x = p[axis];
    x = static_cast<double>(random() % 4);
    for(auto steps = random() % 3; steps > 0; --steps)
      x = std::nextafter(x, random() % 2 == 0 ? -10 : 10);
    x *= scale;
  }
  return p;
}

void expect_exact(double scale, const Vector& shift, Random& random)
{
  const Exact_predicates<Traits> predicates(traits);
  const auto point = [](const Vector& p) { return to_point(p, traits); };
  for(int k = 0; k < 20000; ++k) {
    std::vector<Vector> x;
    for(int i = 0; i < 5; ++i) x.push_back(near_lattice(scale, random) + shift);
    const Filtered_triangle triangle(x[0], x[1], x[2], traits);
    const bool meets = predicates.does_segment_meet_triangle(point(x[3]), point(x[4]), point(x[0]),
                                                             point(x[1]), point(x[2]));
    ASSERT_EQ(triangle.meets(x[3], x[4]), meets);
    ASSERT_FALSE(meets && triangle.is_far_from_plane(x[3], x[4], 0));
    ASSERT_EQ(triangle.is_flat(), predicates.are_collinear(point(x[0]), point(x[1]), point(x[2])));
    if(x[3] != x[0]) {
      ASSERT_EQ(triangle.meets_beyond_a(x[3]),
                predicates.does_segment_meet_triangle_beyond_corner(point(x[0]), point(x[3]),
                                                                    point(x[1]), point(x[2])));
    }
    if(x[3] != x[2]) {
      ASSERT_EQ(triangle.meets_beyond_c(x[3]),
                predicates.does_segment_meet_triangle_beyond_corner(point(x[2]), point(x[3]),
                                                                    point(x[0]), point(x[1])));
    }
  }
}

TEST(Filtered_triangle, agrees_with_the_exact_predicates)
{
  Random random(1);
  expect_exact(1, Vector(0, 0, 0), random);
  expect_exact(0.1, Vector(0.3, 1e3, -1e-3), random);
}

TEST(Filtered_triangle, agrees_with_the_exact_predicates_at_every_scale)
{
  Random random(2);
  for(int exponent : {-1000, -350, -300, -100, 100, 300, 330, 337, 339, 341, 343, 400, 498})
    expect_exact(std::ldexp(1., exponent), Vector(0, 0, 0), random);
}

// Where a product of three differences overflows although its factors are of ordinary size, as in a
// Hopf link from 4e102 on that version 0.1.0 took for a trivial one.
TEST(Filtered_triangle, trusts_no_sign_of_what_overflows)
{
  Random random(3);
  for(int exponent : {100, 300, 500, 900})
    for(int axis = 0; axis < 3; ++axis) {
      Vector shift(0, 0, 0);
      shift[axis] = std::ldexp(1., exponent);
      expect_exact(std::ldexp(1., exponent - 30), shift, random);
    }
  const double inf = 1e308;
  const Filtered_triangle triangle({0, 0, 0}, {inf, 0, 0}, {0, inf, 0}, traits);
  EXPECT_EQ(triangle.side({0, 0, inf}), 0);
  EXPECT_FALSE(triangle.is_far_from_plane({0, 0, inf}, {1, 1, inf}, 0));
}

TEST(Filtered_triangle, knows_segments_far_from_the_plane)
{
  const Filtered_triangle triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, traits);
  EXPECT_TRUE(triangle.is_far_from_plane({0, 0, 2}, {5, 5, 1}, 0.99));
  EXPECT_FALSE(triangle.is_far_from_plane({0, 0, 2}, {5, 5, 1}, 1.01));
  EXPECT_FALSE(triangle.is_far_from_plane({0, 0, 2}, {5, 5, -1}, 0));
}

} // namespace test_filtered_triangle
