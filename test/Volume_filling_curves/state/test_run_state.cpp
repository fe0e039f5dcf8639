// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/resumed_run_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

// Runs resume from no other state than their own.
namespace test_run_state {

using namespace resumed_run_test;

Network trefoil()
{
  return make_torus_knot(2, 3, 40);
}

Parameters flow()
{
  return by(Untangling_strategy::FLOW, 0.3);
}

Run_state state_of_trefoil()
{
  return run_from(untangling, trefoil(), flow(), {}, 3).state;
}

TEST(Run_state, bytes_that_are_damaged_or_cut_off_are_refused)
{
  const std::string bytes = state_of_trefoil().bytes();
  EXPECT_EQ(Run_state(bytes).bytes(), bytes);
  for(std::size_t i = 0; i < bytes.size(); i += i < 64 ? 1 : 61) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    EXPECT_THROW(Run_state{damaged}, Run_state_error) << "byte " << i;
    EXPECT_THROW(Run_state(bytes.substr(0, i)), Run_state_error) << i;
  }
  EXPECT_THROW(Run_state(bytes + '\0'), Run_state_error);
}

std::string bytes_of(const std::vector<double>& numbers)
{
  std::string bytes(numbers.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

// A state with other numbers, and the checksum of these.
Run_state forged(const Run_state& state, const std::string& from, const std::string& to)
{
  std::string body(state.body());
  const std::size_t begin = body.find(from);
  EXPECT_NE(begin, std::string::npos);
  return Run_state::sealed(body.replace(begin, from.size(), to));
}

TEST(Run_state, curves_and_numbers_that_are_forged_are_refused)
{
  const Run_state state = state_of_trefoil();
  const std::vector<double> numbers = run_from(untangling, trefoil(), flow(), {}, 3).numbers;
  const auto at = [&](std::size_t v) {
    return bytes_of({numbers[7 * v], numbers[7 * v + 1], numbers[7 * v + 2]});
  };
  const std::string nan = bytes_of({std::numeric_limits<double>::quiet_NaN()});
  for(const Run_state& other :
      {forged(state, at(0), at(105)), forged(state, at(0), at(0).substr(8) + nan),
       forged(state, bytes_of({0.3}), nan), Run_state::sealed(state.body().substr(0, 2000))})
    EXPECT_THROW(run_from(untangling, trefoil(), flow(), other, 4), Run_state_error);
  const Run_state contradicting = forged(state, bytes_of({0.3}), nan);
  Network curve = trefoil();
  EXPECT_THROW(untangle(curve, parameters::strategy(Untangling_strategy::FLOW)
                                   .thickness(0.3)
                                   .resume_from(std::cref(contradicting))),
               Run_state_error);
  EXPECT_EQ(contents(curve), contents(trefoil()));
}

std::string complaint(const Network& curve, const Parameters& parameters)
{
  try {
    run_from(untangling, curve, parameters, state_of_trefoil(), 4);
  } catch(const Run_state_error& error) {
    return error.what();
  }
  return "";
}

TEST(Run_state, another_run_does_not_resume)
{
  const std::string other = "the state is that of a run with another ";
  Parameters parameters = flow();
  parameters.build_name = "1a2b3c4";
  EXPECT_EQ(complaint(trefoil(), parameters), other + "build_name: , not 1a2b3c4");
  parameters = by(Untangling_strategy::FLOW, 0.25);
  EXPECT_EQ(complaint(trefoil(), parameters), other + "thickness: 0.29999999999999999, not 0.25");
  parameters = by(Untangling_strategy::SEARCH, 0.3);
  EXPECT_EQ(complaint(trefoil(), parameters), other + "strategy: flow, not search");
  EXPECT_EQ(complaint(make_torus_knot(2, 3, 41), flow()), other + "curve");
  Network pinned = trefoil();
  pinned.set_pinned(5);
  EXPECT_EQ(complaint(pinned, flow()), other + "curve");
}

TEST(Run_state, a_filling_with_other_shares_or_ports_does_not_resume)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(2, 1, 1));
  Filling parameters = with_sharp_bends();
  parameters.thickness = 0.25;
  for(const double y : {0.2, 0.8}) {
    parameters.ports.push_back({Point(0, y, 0.5)});
    parameters.ports.push_back({Point(2, y, 0.5)});
  }
  parameters.volume_shares = {1, 2};
  const auto resume = [&](const Filling& p, const Run_state& state) {
    return run_from(filling(box), Network(), p, state, state.is_empty() ? 1 : 2).state;
  };
  const Run_state state = resume(parameters, {});
  EXPECT_FALSE(resume(parameters, state).is_empty());
  Filling other = parameters;
  other.volume_shares = {1, 3};
  EXPECT_THROW(resume(other, state), Run_state_error);
  other = parameters;
  other.ports[1].direction = {1, 0, 0.5};
  EXPECT_THROW(resume(other, state), Run_state_error);
}

TEST(Run_state, taking_states_changes_nothing_and_limits_may_be_others)
{
  const auto np = parameters::strategy(Untangling_strategy::FLOW).thickness(0.3);
  Network whole = trefoil(), part = trefoil(), rest = trefoil();
  untangle(whole, np);
  Run_state state;
  untangle(part, np.number_of_iterations(3).checkpoint(
                     [&](const Run_checkpoint& checkpoint) { state = checkpoint.state(); }));
  untangle(rest, np.time_limit(1000).resume_from(std::cref(state)));
  EXPECT_EQ(contents(rest), contents(whole));
}

} // namespace test_run_state
