// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/shape_test_support.h"

#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <cmath>
#include <locale>
#include <string>
#include <vector>

// What the shape of a curve lacks.
namespace test_shape_check {

using namespace shape_test;

TEST(Shape_check, finds_the_bend_radius_of_a_ring)
{
  const Curve curve = curve_of({ring(12, 2)});
  const double inscribed = 2 * std::cos(CGAL_PI / 12); // of the arcs that touch the edges' middles
  EXPECT_NEAR(check(curve, 1, 1).bend.value, inscribed, 1e-12);
  EXPECT_TRUE(check(curve, inscribed, 1).is_passed());
  EXPECT_FALSE(check(curve, 1.001 * inscribed, 1).is_passed());
}

TEST(Shape_check, finds_the_distance_of_strands)
{
  const Curve curve =
      curve_of({segment(9, {-1, 0, 0}, {1, 0, 0}), segment(7, {0, -1, 0.3}, {0, 1, 0.3})});
  const Shape_check result = check(curve, 0.1, 0.5);
  EXPECT_NEAR(result.strands.value, 0.3, 1e-12);
  EXPECT_NEAR(result.strands.share, 0.6, 1e-12);
  EXPECT_TRUE(check(curve, 0.1, 0.3).is_passed());
  EXPECT_FALSE(result.is_passed());
}

// Half of a turn is one strand, the legs of a hairpin are two.
TEST(Shape_check, leaves_out_the_other_side_of_a_bend)
{
  const std::vector<Point> turn = ring(24, 0.6);
  std::vector<Point> hairpin(turn.begin(), turn.begin() + 13);
  EXPECT_TRUE(check(curve_of({hairpin}), 0.5, 1.8).strands.is_kept());
  const std::vector<Point> left = segment(10, {-0.6, 0, 0}, {-0.6, -4, 0});
  const std::vector<Point> right = segment(10, {0.6, -4, 0}, {0.6, 0, 0});
  hairpin.insert(hairpin.begin(), right.begin(), right.end() - 1);
  hairpin.insert(hairpin.end(), left.begin() + 1, left.end());
  EXPECT_NEAR(check(curve_of({hairpin}), 0.5, 1.8).strands.value, 1.2, 1e-9);
}

struct Decimal_comma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
};

TEST(Shape_check, reason_heeds_no_locale)
{
  const std::vector<VFC::Shape_excess_3<Point>> excesses = {{Point(0, 0.5, 0), 0.75, 1.5, true}};
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new Decimal_comma));
  const std::string reason = VFC::internal::shape_reason(excesses);
  std::locale::global(before);
  EXPECT_EQ(reason, "the curve bends with a radius of 0.75, not 1.5, at (0, 0.5, 0)");
}

} // namespace test_shape_check
