// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Thinned_paths.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace test_thinned_paths {

using CGAL::Volume_filling_curves::internal::Thinned_paths;
using CGAL::Volume_filling_curves::internal::Vector;
using Point = CGAL::Volume_filling_curves::Curve_flow_traits_3<>::Point_3;

TEST(Thinned_paths, thin_a_curve_nearby_only_and_without_jumps)
{
  const Thinned_paths none(0.02, {});
  EXPECT_TRUE(none.are_empty());
  EXPECT_EQ(none.thinning(Point(0, 0, 0), 0.5), 1);
  const Thinned_paths paths(0.02, {Vector(0, 0, 0), Vector(0, 0.02, 0)});
  EXPECT_FALSE(paths.are_empty());
  EXPECT_EQ(paths.thinning(Point(0, 0.02, 0), 0.25), 0.25);
  EXPECT_EQ(paths.thinning(Point(0, 0.2, 0), 0.25), 1);
  double last = paths.thinning(Point(0, 0, 0), 0.5);
  EXPECT_EQ(last, 0.5);
  for(double z = 0; z < 0.5; z += 0.001) {
    const double factor = paths.thinning(Point(0, 0, z), 0.5);
    EXPECT_GE(factor, last - 1e-12);
    EXPECT_LE(factor, (std::min)(last + 0.5 * 0.001 / 0.08 + 1e-12, 1.));
    last = factor;
  }
  EXPECT_EQ(last, 1);
}

} // namespace test_thinned_paths
