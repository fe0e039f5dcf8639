// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace test_fill_along_field {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using Box = VFC::Box_domain_3<Kernel>;
using Direction = std::array<double, 3>;

Direction along_z(const Point&)
{
  return {0, 0, 1};
}

TEST(Fill_along_field, strands_follow_it)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 2));
  Curve curve;
  const auto result = VFC::fill(curve, box, preview(0.1).direction_field(along_z));
  EXPECT_EQ(result.status, VFC::Filling_status::CONVERGED);
  EXPECT_GT(VFC::alignment(curve, along_z), 0.75);
  EXPECT_GT(result.coverage.fraction_within_r, 0.77);
  EXPECT_TRUE(result.empty_regions.empty());
  expect_inside(curve, box);
}

TEST(Fill_along_field, strands_follow_one_that_turns)
{
  const Box box(Point(-1, -1, -0.5), Point(1, 1, 0.5));
  const auto around = [](const Point& p) { return Direction{-p.y(), p.x(), 0}; };
  Curve with, without;
  VFC::fill(with, box, preview(0.15).direction_field(around));
  VFC::fill(without, box, preview(0.15));
  EXPECT_GT(VFC::alignment(with, around), 0.55);
  EXPECT_NEAR(VFC::alignment(without, around), 1. / 3, 0.15);
}

TEST(Fill_along_field, is_the_same_for_other_signs_scales_and_threads)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1)), large(Point(0, 0, 0), Point(2, 2, 2));
  const auto field = [](const Point& p) { return Direction{p.x() - 0.5, 1, 0}; };
  const auto turned = [](const Point& p) { return Direction{1 - p.x(), -2, 0}; };
  const auto options = [](double r) { return preview(r).number_of_iterations(12); };
  Curve once, again;
  VFC::fill(once, box, options(0.15).direction_field(field));
  VFC::fill<CGAL::Parallel_if_available_tag>(again, box, options(0.15).direction_field(field));
  ASSERT_EQ(once.number_of_nodes(), again.number_of_nodes());
  for(std::size_t v = 0; v < once.number_of_nodes(); ++v) ASSERT_EQ(once.point(v), again.point(v));
  Curve scaled;
  VFC::fill(scaled, large, options(0.3).direction_field(turned));
  ASSERT_EQ(once.number_of_nodes(), scaled.number_of_nodes());
  for(std::size_t v = 0; v < once.number_of_nodes(); ++v) {
    const Point& p = once.point(v);
    ASSERT_EQ(Point(2 * p.x(), 2 * p.y(), 2 * p.z()), scaled.point(v));
  }
}

TEST(Fill_along_field, without_weight_is_as_without_a_field)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const auto options = preview(0.2).number_of_iterations(8);
  Curve with, without;
  VFC::fill(with, box, options.direction_field(along_z).direction_weight(0));
  VFC::fill(without, box, options);
  ASSERT_EQ(with.number_of_nodes(), without.number_of_nodes());
  for(std::size_t v = 0; v < with.number_of_nodes(); ++v)
    ASSERT_EQ(with.point(v), without.point(v));
}

TEST(Fill_along_field, refuses_a_field_or_a_weight_that_makes_no_sense)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const auto bad = [](const Point&) {
    return Direction{std::numeric_limits<double>::quiet_NaN(), 0, 0};
  };
  Curve curve;
  EXPECT_THROW(VFC::fill(curve, box, preview(0.2).direction_field(bad)), std::invalid_argument);
  EXPECT_THROW(VFC::fill(curve, box, preview(0.2).direction_field(along_z).direction_weight(-1)),
               std::invalid_argument);
}

} // namespace test_fill_along_field
