// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

// Runs resume from no other state than their own.
namespace test_run_state {

using namespace untangle_test;
using namespace CGAL::Volume_filling_curves;
using Point = Network::Point_3;

const Network trefoil = make_torus_knot(2, 3, 40);
const auto flow = parameters::strategy(Untangling_strategy::FLOW).thickness(0.3);

// Takes all states of a run, and returns the last one.
template <typename Run, typename NamedParameters>
Run_state last_state(const Run& run, const NamedParameters& np, const Run_state& former = {})
{
  Run_state state;
  const auto keep = [&](const Run_checkpoint& checkpoint) { state = checkpoint.state(); };
  run(np.checkpoint(keep).resume_from(std::cref(former)));
  return state;
}

Run_state state_of_trefoil()
{
  Network curve = trefoil;
  return last_state([&](const auto& np) { untangle(curve, np); }, flow.number_of_iterations(3));
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

// The message with which a state is refused. The curve stays as it is.
template <typename NamedParameters>
std::string refusal(const Network& start, const NamedParameters& np, const Run_state& state)
{
  Network curve = start;
  try {
    untangle(curve, np.resume_from(std::cref(state)));
  } catch(const Run_state_error& error) {
    EXPECT_EQ(contents(curve), contents(start));
    return error.what();
  }
  return "";
}

template <typename Number>
std::string bytes_of(const Number& number)
{
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

// A state with other numbers, and the checksum of these.
Run_state forged(std::string body, const std::string& from, const std::string& to)
{
  const std::size_t begin = body.find(from);
  EXPECT_NE(begin, std::string::npos);
  return Run_state::sealed(body.replace(begin, from.size(), to));
}

TEST(Run_state, curves_and_numbers_that_are_forged_are_refused)
{
  const Run_state state = state_of_trefoil();
  const std::string body(state.body());
  std::string fingerprint;
  std::vector<internal::Vector> points;
  internal::Byte_archive{body}(fingerprint, points);
  const std::string node = bytes_of(points[0]), other_node = bytes_of(points[15]);
  const std::string nan = bytes_of(std::numeric_limits<double>::quiet_NaN());
  for(const Run_state& other :
      {forged(body, node, other_node), forged(body, node, node.substr(8) + nan),
       forged(body, bytes_of(0.3), nan), Run_state::sealed(body.substr(0, 2000))})
    EXPECT_EQ(refusal(trefoil, flow, other).find("the state contradicts itself: "), 0u);
}

TEST(Run_state, another_run_does_not_resume)
{
  const Run_state state = state_of_trefoil();
  const std::string other = "the state is that of a run with another ";
  EXPECT_EQ(refusal(trefoil, flow.build_name("1a2b3c4"), state),
            other + "build_name: , not 1a2b3c4");
  EXPECT_EQ(refusal(trefoil, flow.thickness(0.25), state),
            other + "thickness: 0.29999999999999999, not 0.25");
  EXPECT_EQ(refusal(trefoil, flow.strategy(Untangling_strategy::SEARCH), state),
            other + "strategy: flow, not search");
  Network pinned = trefoil;
  pinned.set_pinned(5);
  for(const Network& curve : {make_torus_knot(2, 3, 41), pinned})
    EXPECT_EQ(refusal(curve, flow, state), other + "curve");
}

TEST(Run_state, a_filling_with_other_shares_or_ports_does_not_resume)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(2, 1, 1));
  std::vector<Port<Point>> ports;
  for(const double y : {0.2, 0.8})
    for(const double x : {0., 2.}) ports.push_back({Point(x, y, 0.5)});
  const auto resume = [&](const std::vector<double>& shares, const Run_state& former) {
    Network curve;
    return last_state([&](const auto& np) { fill(curve, box, np); },
                      parameters::round_bends(false)
                          .thickness(0.25)
                          .ports(ports)
                          .volume_shares(shares)
                          .number_of_iterations(former.is_empty() ? 1 : 2),
                      former);
  };
  const Run_state state = resume({1, 2}, {});
  EXPECT_FALSE(resume({1, 2}, state).is_empty());
  EXPECT_THROW(resume({1, 3}, state), Run_state_error);
  ports[1].direction = {1, 0, 0.5};
  EXPECT_THROW(resume({1, 2}, state), Run_state_error);
}

TEST(Run_state, taking_states_changes_nothing_and_limits_may_be_others)
{
  const Run_state state = state_of_trefoil();
  Network whole = trefoil, rest = trefoil;
  untangle(whole, flow);
  untangle(rest, flow.time_limit(1000).resume_from(std::cref(state)));
  EXPECT_EQ(contents(rest), contents(whole));
}

} // namespace test_run_state
