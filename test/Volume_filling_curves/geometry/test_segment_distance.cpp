// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <gtest/gtest.h>

#include <cmath>

namespace test_segment_distance {

using namespace flow_test;

// Of parallel segments only rounding is left of the cross product, which must not count.
TEST(Segment_distance, of_parallel_segments)
{
  Random random(1);
  for(int repeat = 0; repeat < 10000; ++repeat) {
    const Vector u = random_point(random).normalized();
    const Vector across = u.cross(random_point(random)).normalized();
    const double height = between(0.5, 2, random), shift = between(-0.9, 0.9, random);
    const Vector a = random_point(random), c = a + height * across + shift * u;
    const double length = between(1, 2, random);
    ASSERT_NEAR(std::sqrt(internal::squared_segment_distance(a, a + u, c, c + length * u)), height,
                1e-12);
  }
}

TEST(Segment_distance, of_segments_that_cross_at_small_angles)
{
  Random random(2);
  for(double angle = 1; angle > 1e-12; angle /= 2) {
    const Vector u = random_point(random).normalized();
    const Vector across = u.cross(random_point(random)).normalized(), above = u.cross(across);
    const Vector v = u + angle * across, middle = random_point(random);
    const double height = between(0.5, 2, random);
    const Vector c = middle + height * above;
    ASSERT_NEAR(std::sqrt(internal::squared_segment_distance(middle - u, middle + u, c - v, c + v)),
                height, 1e-12);
  }
}

} // namespace test_segment_distance
