// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/filling/Filling_state.h>

#include <gtest/gtest.h>

#include <cstddef>

// When a curve is polished, and when it cannot be polished further.
namespace test_polishing_record {

using CGAL::Volume_filling_curves::internal::Polishing_record;

TEST(Polishing_record, is_done_when_no_node_exceeds_a_limit)
{
  Polishing_record record;
  record.add(2, 100);
  EXPECT_FALSE(record.is_done());
  EXPECT_DOUBLE_EQ(record.last(), 0.02);
  record.add(0, 100);
  EXPECT_TRUE(record.is_done());
}

TEST(Polishing_record, an_empty_curve_is_done)
{
  Polishing_record record;
  EXPECT_TRUE(record.is_done());
  record.add(0, 0);
  EXPECT_TRUE(record.is_done());
}

TEST(Polishing_record, gives_up_only_after_a_step_that_leaves_most_of_many_nodes)
{
  const auto gives_up = [](std::size_t before, std::size_t after) {
    Polishing_record record;
    record.add(before, 1000);
    EXPECT_FALSE(record.are_limits_out_of_reach()) << "before the first step";
    record.add(after, 1000);
    return record.are_limits_out_of_reach();
  };
  EXPECT_TRUE(gives_up(220, 170));
  EXPECT_TRUE(gives_up(900, 500));
  EXPECT_FALSE(gives_up(900, 400)); // it still succeeds
  EXPECT_TRUE(gives_up(60, 51));
  EXPECT_FALSE(gives_up(60, 40)); // so few may be in one fold
}

} // namespace test_polishing_record
