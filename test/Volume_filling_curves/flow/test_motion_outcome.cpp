// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/flow/Guarded_step.h>

#include <gtest/gtest.h>

// How far nodes got, where some of them had nowhere to go.
namespace test_motion_outcome {

namespace internal = CGAL::Volume_filling_curves::internal;
using internal::motion_outcome;
using internal::Vector_field;

// three nodes, the last one pinned
Vector_field directions()
{
  Vector_field d(3, 3);
  d << 1, 0, 0, 0, -2, 0, 0, 0, 0;
  return d;
}

TEST(Motion_outcome, is_that_of_the_nodes_with_a_way)
{
  const auto outcome = motion_outcome({1, 0.5, 1}, directions());
  EXPECT_EQ(outcome.mean_fraction, 0.75);
  EXPECT_FALSE(outcome.are_nodes_held);
  EXPECT_TRUE(outcome.has_moved());
  EXPECT_TRUE(outcome.is_shortened());
}

TEST(Motion_outcome, tells_held_nodes)
{
  EXPECT_TRUE(motion_outcome({1, 0, 1}, directions()).are_nodes_held);
  EXPECT_TRUE(motion_outcome({1, 0, 1}, directions()).has_moved());
  EXPECT_FALSE(motion_outcome({1, 1, 1}, directions()).is_shortened());
}

TEST(Motion_outcome, counts_no_pinned_node_as_moved)
{
  EXPECT_FALSE(motion_outcome({0, 0, 1}, directions()).has_moved());
}

} // namespace test_motion_outcome
