// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/internal/untangling/flow_monitors.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Default_curve_flow_visitor.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

// When curves flow coarsely, and that they do not end so.
namespace test_coarse_phase {

using namespace untangle_test;
using CGAL::Volume_filling_curves::Untangling_strategy;
using internal::Coarse_phase;

// Notes lengths that fall by the same part in each step, and returns whether the phase is on after
// each.
std::vector<bool> states(Coarse_phase& phase, double fall, std::size_t number_of_steps)
{
  std::vector<bool> states;
  double length = 5;
  for(std::size_t k = 0; k < number_of_steps; ++k) {
    phase.note(length);
    states.push_back(phase.is_on());
    length *= 1 - fall;
  }
  return states;
}

std::ptrdiff_t count(const std::vector<bool>& states)
{
  return std::count(states.begin(), states.end(), true);
}

TEST(Coarse_phase, begins_where_the_gradient_is_large)
{
  Coarse_phase phase;
  EXPECT_FALSE(phase.is_on());
  phase.begin(0.05);
  EXPECT_FALSE(phase.is_on());
  phase.begin(0.3);
  EXPECT_TRUE(phase.is_on());
  phase.end();
  EXPECT_FALSE(phase.is_on());
}

TEST(Coarse_phase, lasts_while_the_length_falls_fast)
{
  Coarse_phase fast, slow;
  fast.begin(1);
  slow.begin(1);
  EXPECT_EQ(count(states(fast, 0.003, 50)), 50);
  EXPECT_EQ(count(states(slow, 0.0005, 50)), 10);
}

TEST(Coarse_phase, begins_again_where_the_length_falls_faster_than_it_must_to_go_on)
{
  Coarse_phase phase;
  EXPECT_EQ(count(states(phase, 0.003, 50)), 0);
  EXPECT_TRUE(states(phase, 0.01, 50).back());
}

// Remembers the least and the largest number of nodes per thickness of length, from the start on.
struct Density : CGAL::Volume_filling_curves::Default_curve_flow_visitor
{
  double least = 1e300, largest = 0;

  template <typename Flow>
  void on_start(const Flow& flow)
  {
    note(flow);
  }

  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    note(flow);
  }

  template <typename Flow>
  void note(const Flow& flow)
  {
    const auto n = static_cast<double>(flow.curve().number_of_nodes());
    const double density = n * flow.thickness() / flow.length();
    least = (std::min)(least, density);
    largest = (std::max)(largest, density);
  }
};

// Edges are between 0.2 and 0.4 thicknesses long in the end.
void expect_fine(const Network& curve, const Untangling_result& result)
{
  const double density = static_cast<double>(curve.number_of_nodes()) * result.thickness /
                         internal::total_length(curve);
  EXPECT_GT(density, 1 / 0.4);
  EXPECT_LT(density, 1 / 0.2);
}

TEST(Coarse_phase, is_over_when_a_run_ends)
{
  for(const std::size_t most : {1u, 5u, 10000u}) {
    Network knot = tangled(braid("1 1 1", 60), 3);
    Density density;
    const auto flow = parameters::strategy(Untangling_strategy::FLOW).number_of_iterations(most);
    const Untangling_result result = untangle(knot, flow.visitor(std::ref(density)));
    EXPECT_EQ(result.status,
              most == 10000 ? Untangling_status::CONVERGED : Untangling_status::LIMIT);
    EXPECT_LT(density.least, 1 / 0.5);
    expect_fine(knot, result);
  }
}

TEST(Coarse_phase, leaves_tight_curves_as_they_are)
{
  Network knot = tangled(braid("1 1 1", 60), 3);
  const double thickness = untangle(knot).thickness;
  Density density;
  const Untangling_result result = untangle(knot, parameters::strategy(Untangling_strategy::FLOW)
                                                      .thickness(thickness)
                                                      .visitor(std::ref(density)));
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_GT(density.least, 1 / 0.4);
}

TEST(Coarse_phase, is_left_out_where_coarse_edges_are_asked_for)
{
  Network knot = tangled(braid("1 1 1", 60), 3);
  Density density;
  untangle(knot, parameters::strategy(Untangling_strategy::FLOW)
                     .spacing(0.6)
                     .number_of_iterations(20)
                     .visitor(std::ref(density)));
  EXPECT_LT(density.largest, 1 / 0.6);
}

} // namespace test_coarse_phase
