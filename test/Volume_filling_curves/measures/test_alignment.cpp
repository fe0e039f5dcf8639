// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace test_alignment {

using namespace flow_test;
using CGAL::Volume_filling_curves::alignment;
using Point = Network::Point_3;
using Direction = std::array<double, 3>;

double alignment_with(const Network& curve, const Direction& direction)
{
  return alignment(curve, [&](const Point&) { return direction; });
}

TEST(Alignment, is_one_along_and_zero_across)
{
  const Network line = path({{0, 0, 0}, {0, 0, 1}, {0, 0, 5}});
  EXPECT_EQ(alignment_with(line, {0, 0, 1}), 1);
  EXPECT_EQ(alignment_with(line, {0, 0, -3}), 1) << "neither sign nor length matters";
  EXPECT_EQ(alignment_with(line, {0, 0, 1e-300}), 1);
  EXPECT_EQ(alignment_with(line, {0, 0, 1e300}), 1);
  EXPECT_EQ(alignment_with(line, {1, 2, 0}), 0);
  EXPECT_NEAR(alignment_with(line, {0, 1, 1}), 0.5, 1e-15);
}

TEST(Alignment, is_a_mean_by_length)
{
  const Network corner = path({{0, 0, 0}, {3, 0, 0}, {3, 0, 1}});
  EXPECT_NEAR(alignment_with(corner, {0, 0, 1}), 0.25, 1e-15);
  EXPECT_NEAR(alignment_with(internal::closed_network({circle(64)}), {1, 0, 0}), 0.5, 1e-14);
}

TEST(Alignment, leaves_out_where_there_is_no_direction)
{
  const Network corner = path({{0, 0, 0}, {3, 0, 0}, {3, 0, 1}});
  const auto field = [](const Point& p) { return Direction{0, 0, p.z() > 0 ? 1. : 0.}; };
  EXPECT_EQ(alignment(corner, field), 1);
  EXPECT_TRUE(std::isnan(alignment_with(corner, {0, 0, 0})));
}

TEST(Alignment, names_the_place_where_a_field_is_not_finite)
{
  try {
    (void)alignment_with(path({{0, 0, 0}, {3, 0, 1}}),
                         {0, std::numeric_limits<double>::infinity(), 0});
    FAIL() << "it was accepted";
  } catch(const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "direction_field is not finite at (1.5, 0, 0.5)");
  }
}

} // namespace test_alignment
