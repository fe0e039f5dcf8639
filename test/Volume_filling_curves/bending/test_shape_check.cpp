// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <locale>
#include <string>
#include <vector>

namespace test_shape_check {

namespace VFC = CGAL::Volume_filling_curves;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

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
