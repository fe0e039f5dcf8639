// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/internal/flow/Step_size.h>
#include <CGAL/Volume_filling_curves/internal/untangling/flow_monitors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// The length of a step, and the detection of a flow without progress.
namespace test_step_size {

using namespace flow_test;
using internal::Stall_monitor;
using internal::Step_size;

Vector_field two_rows(double x, double y)
{
  Vector_field field = Vector_field::Zero(2, 3);
  field(0, 0) = x;
  field(1, 1) = y;
  return field;
}

// the next factor of a direction where all nodes have the thickness 1
double next(Step_size& step_size, const Vector_field& direction)
{
  return step_size.next(direction,
                        std::vector<double>(static_cast<std::size_t>(direction.rows()), 1.));
}

TEST(Step_size, starts_with_the_largest_displacement)
{
  Step_size step_size(0.5);
  EXPECT_EQ(next(step_size, two_rows(4, -1)), 0.125);
}

TEST(Step_size, measures_displacements_in_units_of_the_nodes_thickness)
{
  Step_size step_size(0.5);
  EXPECT_EQ(step_size.next(two_rows(4, -1), {16, 2}), 1); // node 1 goes half of its thickness
  Step_size wider(0.5);
  wider.max_displacement = 2;
  EXPECT_EQ(wider.next(two_rows(4, -1), {16, 2}), 4);
}

TEST(Step_size, never_moves_a_node_farther_than_allowed)
{
  Random random(1);
  Step_size step_size(0.5);
  for(int k = 0; k < 1000; ++k) {
    const Vector_field direction = std::exp(between(-20, 20, random)) * random_field(10, random);
    const double factor = next(step_size, direction);
    ASSERT_GT(factor, 0);
    ASSERT_LE(factor * direction.rowwise().norm().maxCoeff(), 0.5 * (1 + 1e-14));
    if(k % 50 == 0) step_size.note_fraction(0.25);
  }
}

TEST(Step_size, grows_while_the_direction_stays_the_same)
{
  Step_size step_size(1);
  const double first = next(step_size, two_rows(1, 0));
  next(step_size, two_rows(0.01, 0));
  double last = next(step_size, two_rows(0.01, 0));
  EXPECT_GT(last, first);
  for(int k = 0; k < 5; ++k) {
    const double grown = next(step_size, two_rows(0.01, 0));
    EXPECT_NEAR(grown, 1.3 * last, 1e-12);
    last = grown;
  }
  for(int k = 0; k < 50; ++k) last = next(step_size, two_rows(0.01, 0));
  EXPECT_EQ(last, 100); // the displacement is 1
}

TEST(Step_size, shrinks_when_the_direction_turns_back)
{
  Step_size step_size(1);
  const double first = next(step_size, two_rows(1, 0));
  EXPECT_NEAR(next(step_size, two_rows(-0.1, 0.9)), 0.6 * first, 1e-15);
}

// Half, a third, ... of the growth after a turn, two turns, ...; a turn is forgotten in the end.
TEST(Step_size, grows_less_after_turns)
{
  Step_size step_size(1);
  next(step_size, two_rows(1, 0));
  step_size.max_displacement = 1e9;
  const auto growth = [&] {
    const double last = next(step_size, two_rows(1, 0));
    return next(step_size, two_rows(1, 0)) / last - 1;
  };
  EXPECT_NEAR(growth(), 0.3, 1e-12);
  for(int turns = 1; turns < 4; ++turns) {
    next(step_size, two_rows(-1, 0));
    next(step_size, two_rows(0, 1));
    EXPECT_NEAR(growth(), 0.3 / (1 + turns), 0.02);
  }
  step_size.max_displacement = 1;
  for(int k = 0; k < 500; ++k) next(step_size, two_rows(1, 0));
  step_size.max_displacement = 1e9;
  EXPECT_NEAR(growth(), 0.3, 1e-3);
}

// After a step that made the direction vanish by a tenth, ten such steps would do.
TEST(Step_size, follows_the_rate_at_which_the_direction_falls)
{
  Step_size step_size(1);
  const double first = next(step_size, two_rows(1, 0));
  EXPECT_NEAR(next(step_size, two_rows(0.1, 0)), first / 0.9, 1e-12);
  EXPECT_NEAR(next(step_size, two_rows(0.09, 0)), 1.3 * first / 0.9, 1e-12);
}

TEST(Step_size, shrinks_after_a_step_of_which_little_was_certified)
{
  Step_size step_size(1);
  const double first = next(step_size, two_rows(1, 0));
  step_size.note_fraction(0.75);
  EXPECT_NEAR(next(step_size, two_rows(0, 1)), first, 1e-12);
  step_size.note_fraction(0.25);
  EXPECT_NEAR(next(step_size, two_rows(1, 0)), 0.7 * first, 1e-12);
}

TEST(Step_size, remembers_the_direction_of_the_nodes_that_are_left)
{
  Step_size step_size(1), other(1);
  const double first = next(step_size, two_rows(1, 0.5));
  step_size.renumber({1, static_cast<std::uint32_t>(-1), 0});
  Vector_field direction = Vector_field::Zero(3, 3);
  direction.row(2) << -1, 0, 0; // of the node that was the first one
  direction.row(1) << 0, 0, 1;
  EXPECT_NEAR(next(step_size, direction), 0.6 * first, 1e-12);
  other.renumber({0, 1}); // before the first step
  EXPECT_EQ(next(other, two_rows(1, 0)), 1);
}

TEST(Step_size, survives_a_direction_that_vanished)
{
  Step_size step_size(1);
  next(step_size, two_rows(1, 0));
  step_size.renumber({5, 5}); // no node is left
  EXPECT_TRUE(std::isfinite(next(step_size, two_rows(1, 0))));
}

TEST(Stall_monitor, gives_up_after_five_steps_without_motion)
{
  Stall_monitor monitor;
  for(int k = 0; k < 4; ++k) EXPECT_FALSE(monitor(1, 1, false));
  EXPECT_FALSE(monitor(1, 1, true));
  for(int k = 0; k < 4; ++k) EXPECT_FALSE(monitor(1, 1, false));
  EXPECT_TRUE(monitor(1, 1, false));
}

TEST(Stall_monitor, notices_that_neither_length_nor_gradient_change)
{
  Stall_monitor monitor;
  for(int k = 0; k < 100; ++k) EXPECT_FALSE(monitor(1, 1, true));
  EXPECT_TRUE(monitor(1, 1, true));
}

TEST(Stall_monitor, is_patient_while_something_falls)
{
  Stall_monitor length, gradient;
  for(int k = 0; k < 1000; ++k) {
    EXPECT_FALSE(length(std::pow(0.99998, k), 1, true));
    EXPECT_FALSE(gradient(1, std::pow(0.9998, k), true));
  }
}

} // namespace test_step_size
