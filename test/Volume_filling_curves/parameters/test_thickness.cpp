// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <vector>

namespace test_thickness {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Thickness = CGAL::Volume_filling_curves::internal::Thickness<Point>;

const std::vector<Point> points = {Point(1, 0, 0), Point(2, 0, 0), Point(6, 0, 0)};

Thickness field()
{
  return Thickness(0, [](const Point& p) { return p.x(); });
}

TEST(Thickness, is_raised_where_it_is_less)
{
  EXPECT_EQ(field().raised_to(3).at_each(points), (std::vector<double>{3, 3, 6}));
  EXPECT_EQ(field().raised_to(0.5).at_each(points), (std::vector<double>{1, 2, 6}));
  EXPECT_EQ(Thickness(2).raised_to(3).number(), 3);
  EXPECT_EQ(Thickness(2).raised_to(3)(points[0]), 3);
  EXPECT_EQ(Thickness(4).raised_to(3).number(), 4);
}

TEST(Thickness, has_the_mean_of_raised_values)
{
  EXPECT_EQ(field().averaged_at(points).number(), 3);
  EXPECT_EQ(field().raised_to(3).averaged_at(points).number(), 4);
}

TEST(Thickness, scales_with_its_minimum)
{
  EXPECT_EQ((2 * field().raised_to(3)).at_each(points), (std::vector<double>{6, 6, 12}));
}

// Where the domain is too narrow, the curve may be thinner than the minimum.
TEST(Thickness, is_thinned_after_it_is_raised)
{
  const Thickness thinned = field().raised_to(3).thinned([](const Point&) { return 0.5; });
  EXPECT_EQ(thinned.at_each(points), (std::vector<double>{1.5, 1.5, 3}));
}

} // namespace test_thickness
