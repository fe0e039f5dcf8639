// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/filling/Filling_state.h>

#include <gtest/gtest.h>

#include <cmath>

// When the length of a growing curve counts as settled.
namespace test_length_window {

using CGAL::Volume_filling_curves::internal::Length_window;

TEST(Length_window, has_not_settled_before_it_has_seen_enough)
{
  Length_window lengths;
  for(int k = 0; k <= 10; ++k) {
    EXPECT_FALSE(lengths.has_settled(10, 0.01));
    lengths.add(5);
  }
  EXPECT_TRUE(lengths.has_settled(10, 0.01));
}

TEST(Length_window, looks_at_the_last_iterations_only)
{
  Length_window lengths;
  for(int k = 0; k < 100; ++k) lengths.add(k);
  EXPECT_FALSE(lengths.has_settled(3, 0.01));
  for(int k = 0; k < 3; ++k) lengths.add(100);
  EXPECT_FALSE(lengths.has_settled(3, 0.01)); // the 99 counts
  lengths.add(100);
  EXPECT_TRUE(lengths.has_settled(3, 0.01));
  EXPECT_FALSE(lengths.has_settled(4, 0.01));
}

TEST(Length_window, counts_a_bump_as_a_change)
{
  Length_window lengths;
  for(const double length : {100., 102., 100.}) lengths.add(length);
  EXPECT_FALSE(lengths.has_settled(2, 0.019));
  EXPECT_TRUE(lengths.has_settled(2, 0.02));
}

TEST(Length_window, judges_by_a_fraction_of_the_length)
{
  for(const double unit : {1e-200, 1., 1e200}) {
    Length_window lengths;
    for(int k = 0; k < 5; ++k) lengths.add(unit * std::pow(1.001, k));
    EXPECT_TRUE(lengths.has_settled(4, 0.0041));
    EXPECT_FALSE(lengths.has_settled(4, 0.0039));
  }
}

} // namespace test_length_window
