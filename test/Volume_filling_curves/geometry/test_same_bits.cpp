// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace test_same_bits {

using namespace CGAL::Volume_filling_curves::internal;

constexpr double few_bits = 4 * std::numeric_limits<double>::epsilon();

TEST(Turning_angle, is_that_of_the_library_but_for_the_last_bits)
{
  const Vector in(1, 0, 0);
  for(int k = 1; k <= 1000; ++k) {
    const double angle = 3.14159 * k / 1000;
    const Vector out(std::cos(angle), 0, std::sin(angle));
    const double expected = std::atan2(in.cross(out).norm(), in.dot(out));
    EXPECT_NEAR(turning_angle(in, out), expected, few_bits * expected) << k;
    EXPECT_NEAR(bend_radius(in, out) * 2 * std::tan(expected / 2), 1, 3 * few_bits) << k;
  }
}

TEST(Turning_angle, is_accurate_for_straight_and_for_folded_corners)
{
  const Vector in(1, 0, 0);
  for(double tiny : {1e-3, 1e-8, 1e-100}) {
    EXPECT_NEAR(turning_angle(in, Vector(1, tiny, 0)) / std::atan(tiny), 1, few_bits);
    EXPECT_NEAR(turning_angle(in, Vector(-1, tiny, 0)), CGAL_PI - std::atan(tiny), 4 * few_bits);
  }
  EXPECT_EQ(turning_angle(in, in), 0);
  EXPECT_EQ(turning_angle(in, -in), CGAL_PI);
  EXPECT_EQ(turning_angle(in, Vector()), 0);
  EXPECT_EQ(bend_radius(in, -in), 0);
  EXPECT_EQ(bend_radius(in, in), std::numeric_limits<double>::infinity());
}

TEST(Cube_root, is_that_of_the_library_but_for_the_last_bit)
{
  for(double x = 1e-300; x < 1e300; x *= 1.7)
    EXPECT_NEAR(cube_root(x) / std::cbrt(x), 1, few_bits) << x;
  EXPECT_EQ(cube_root(0), 0);
  EXPECT_EQ(cube_root(27), 3);
  EXPECT_EQ(cube_root(0.125), 0.5);
}

TEST(Stable_norm, neither_underflows_nor_overflows)
{
  EXPECT_DOUBLE_EQ(stable_norm(Vector(3e200, -4e200, 0)), 5e200);
  EXPECT_DOUBLE_EQ(stable_norm(Vector(0, 3e-200, 4e-200)), 5e-200);
  EXPECT_EQ(stable_norm(Vector()), 0);
  EXPECT_EQ(stable_norm(Vector(std::numeric_limits<double>::infinity(), 0, 0)),
            std::numeric_limits<double>::infinity());
}

// (1 + tiny) + tiny is 1, tiny + (tiny + 1) is not
TEST(Sums_over_rows, are_taken_in_order)
{
  const double tiny = std::numeric_limits<double>::epsilon() / 2;
  Vector_field x(3, 3), ones = Vector_field::Ones(3, 3);
  x << 1, 0, 0, tiny, 0, 0, tiny, 0, 0;
  EXPECT_EQ(dot(x, ones), 1);
  EXPECT_EQ(sum_of_norms(x), 1);
  EXPECT_GT(dot(x.colwise().reverse().eval(), ones), 1);
}

} // namespace test_same_bits
