// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/resume_test_support.h"
#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>
#include <CGAL/Volume_filling_curves/internal/state/Replay_log.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// States of runs as bytes, and which of them a run resumes from.
namespace test_run_state {

using namespace untangle_test;
using namespace resume_test;
using CGAL::Volume_filling_curves::make_torus_knot;
using CGAL::Volume_filling_curves::Run_state_error;
using CGAL::Volume_filling_curves::Untangling_parameters;
using CGAL::Volume_filling_curves::Untangling_strategy;
using internal::Replay_log;
using internal::State_reader;
using internal::State_writer;

struct Sample
{
  double x = 0;
  std::vector<bool> flags;

  template <typename Archive>
  void serialize(Archive& archive)
  {
    archive(x, flags);
  }
};

std::string bytes_of_samples()
{
  State_writer writer;
  writer(std::vector<Sample>{{-0., {true, false}}, {0.1, {}}}, std::string("a\0b", 3),
         std::optional<int>(-7), std::optional<double>(), std::array<std::size_t, 1>{2},
         std::pair<std::uint64_t, bool>(std::uint64_t(-1), true));
  return writer.bytes();
}

TEST(Run_state, archives_give_back_what_was_written)
{
  const std::string bytes = bytes_of_samples();
  State_reader reader(bytes);
  std::vector<Sample> samples(5);
  std::string text;
  std::optional<int> some;
  std::optional<double> none = 1;
  std::size_t size = 0;
  std::pair<std::uint64_t, bool> pair;
  reader(samples, text, some, none, size, pair);
  EXPECT_TRUE(reader.is_at_end());
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_TRUE(std::signbit(samples[0].x));
  EXPECT_EQ(samples[0].flags, (std::vector<bool>{true, false}));
  EXPECT_EQ(samples[1].x, 0.1);
  EXPECT_EQ(text, std::string("a\0b", 3));
  EXPECT_EQ(some, -7);
  EXPECT_FALSE(none);
  EXPECT_EQ(size, 2u);
  EXPECT_EQ(pair.first, std::uint64_t(-1));
  EXPECT_TRUE(pair.second);
}

TEST(Run_state, archives_that_end_early_are_refused)
{
  const std::string bytes = bytes_of_samples();
  for(std::size_t length = 0; length < bytes.size(); ++length) {
    State_reader reader(std::string_view(bytes).substr(0, length));
    std::vector<Sample> samples;
    std::string text;
    std::optional<int> some;
    std::optional<double> none;
    std::size_t size = 0;
    std::pair<std::uint64_t, bool> pair;
    EXPECT_THROW(reader(samples, text, some, none, size, pair), Run_state_error) << length;
  }
}

TEST(Run_state, decisions_are_taken_once)
{
  Replay_log first;
  first([] { return 3; });
  first([] { return std::vector<double>{0.1, 0.2}; });
  State_writer writer;
  writer(first);
  State_reader reader(writer.bytes());
  Replay_log second;
  reader(second);
  EXPECT_EQ(second([] { return 4; }), 3);
  EXPECT_EQ(second([] { return std::vector<double>(); }), (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(second([] { return 5; }), 5);
}

Untangling_parameters flow_parameters()
{
  Untangling_parameters parameters;
  parameters.strategy = Untangling_strategy::FLOW;
  parameters.thickness = 0.3;
  return parameters;
}

const auto run = [](Network& curve, const Untangling_parameters& parameters, auto visitor) {
  return untangle(curve, parameters, visitor);
};

Interruption after(std::size_t steps)
{
  Interruption interruption;
  interruption.steps = steps;
  return interruption;
}

Network trefoil()
{
  return make_torus_knot(2, 3, 40);
}

Run_state state_of_trefoil()
{
  return run_from(run, trefoil(), flow_parameters(), {}, after(3)).state;
}

// of a few nodes
Run_state small_state()
{
  Network curve = make_torus_knot(2, 3, 30);
  Run_state state;
  Untangling_parameters parameters = flow_parameters();
  parameters.thickness = 3;
  parameters.number_of_iterations = 1;
  parameters.checkpoint = [&](const Run_checkpoint& checkpoint) { state = checkpoint.state(); };
  untangle(curve, parameters);
  return state;
}

TEST(Run_state, bytes_that_are_damaged_anywhere_are_refused)
{
  const std::string bytes = small_state().bytes();
  ASSERT_GT(bytes.size(), 100u);
  EXPECT_EQ(Run_state(bytes).bytes(), bytes);
  for(std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    EXPECT_THROW(Run_state{damaged}, Run_state_error) << "byte " << i;
  }
}

TEST(Run_state, bytes_that_are_cut_off_or_too_many_are_refused)
{
  const std::string bytes = small_state().bytes();
  for(std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(Run_state(bytes.substr(0, length)), Run_state_error) << length;
  EXPECT_THROW(Run_state(bytes + '\0'), Run_state_error);
  EXPECT_THROW(Run_state("v 0 0 0\n"), Run_state_error);
}

// A state with other bytes, and the checksum of these.
Run_state forged(const Run_state& state, const std::string& from, const std::string& to)
{
  const std::size_t checksum_size = 32;
  std::string bytes = state.bytes().substr(0, state.bytes().size() - checksum_size);
  const std::size_t begin = bytes.find(from);
  EXPECT_NE(begin, std::string::npos);
  bytes.replace(begin, from.size(), to);
  const auto digest = internal::sha256(bytes);
  return Run_state(bytes + std::string(digest.begin(), digest.end()));
}

template <typename... Objects>
std::string archived(const Objects&... objects)
{
  State_writer writer;
  writer(objects...);
  return writer.bytes();
}

// Numbers of nodes, edges, components and chains among them: none leads anywhere else.
TEST(Run_state, networks_with_forged_numbers_are_refused)
{
  using Point = Network::Point_3;
  const Network curve({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(5, 0, 0),
                       Point(6, 0, 0), Point(5, 1, 0), Point(5, 0, 1)},
                      {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {3, 5}, {3, 6}});
  const std::string bytes = archived(curve);
  std::size_t number_refused = 0;
  for(std::size_t i = 0; i + 8 <= bytes.size(); i += 8)
    for(const std::uint64_t number : {0ull, 1ull, 7ull, 0xffffffffull, 1ull << 63}) {
      std::string other = bytes;
      other.replace(i, 8, archived(number));
      State_reader reader(other);
      Network read;
      try {
        reader(read);
      } catch(const Run_state_error&) {
        ++number_refused;
        continue;
      }
      EXPECT_EQ(read.number_of_nodes(), curve.number_of_nodes());
      for(const auto& origin : curve_origins(read)) EXPECT_LE(origin.parameter, 1);
    }
  EXPECT_GT(number_refused, 100u);
}

TEST(Run_state, curves_that_are_forged_to_touch_themselves_are_refused)
{
  const Run_state state = state_of_trefoil();
  Network curve = trefoil();
  Untangling_parameters parameters = flow_parameters();
  parameters.number_of_iterations = 3;
  untangle(curve, parameters);
  const auto at = [&](std::size_t v) {
    return archived(curve.point(v).x(), curve.point(v).y(), curve.point(v).z());
  };
  const Run_state other = forged(state, at(0), at(curve.number_of_nodes() / 2));
  EXPECT_THROW(run_from(run, trefoil(), flow_parameters(), other, after(4)), Run_state_error);
  EXPECT_NO_THROW(run_from(run, trefoil(), flow_parameters(), state, after(4)));
}

// A run that took 2^60 directions for its own would take all memory, and with a thickness of NaN it
// would not know where its edges end.
TEST(Run_state, parameters_that_are_forged_are_refused)
{
  const Run_state state = state_of_trefoil();
  const Untangling_parameters p = flow_parameters();
  const std::string directions = archived(p.number_of_directions, p.max_radius);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const Run_state& other :
      {forged(state, directions, archived(std::size_t(1) << 60, p.max_radius)),
       forged(state, directions, archived(std::size_t(0), p.max_radius)),
       forged(state, directions, archived(p.number_of_directions, nan)),
       forged(state, archived(p.thickness) + directions, archived(nan) + directions)})
    EXPECT_THROW(run_from(run, trefoil(), p, other, after(4)), Run_state_error);
}

std::string complaint(const Network& curve, const Untangling_parameters& parameters)
{
  try {
    run_from(run, curve, parameters, state_of_trefoil(), after(4));
  } catch(const Run_state_error& error) {
    return error.what();
  }
  return "";
}

TEST(Run_state, a_run_with_another_parameter_does_not_resume)
{
  Untangling_parameters parameters = flow_parameters();
  parameters.thickness = 0.25;
  EXPECT_EQ(complaint(trefoil(), parameters),
            "the state is that of a run with another thickness: 0.29999999999999999, not 0.25");
  parameters = flow_parameters();
  parameters.strategy = Untangling_strategy::SEARCH;
  EXPECT_EQ(complaint(trefoil(), parameters),
            "the state is that of a run with another strategy: flow, not search");
  parameters = flow_parameters();
  parameters.random_seed = 1;
  EXPECT_EQ(complaint(trefoil(), parameters),
            "the state is that of a run with another random_seed: 0, not 1");
}

TEST(Run_state, another_build_of_the_same_version_does_not_resume)
{
  Untangling_parameters parameters = flow_parameters();
  parameters.build_name = "1a2b3c4";
  EXPECT_EQ(complaint(trefoil(), parameters),
            "the state is that of a run with another build_name: , not 1a2b3c4");
}

TEST(Run_state, a_run_of_another_curve_does_not_resume)
{
  EXPECT_EQ(complaint(make_torus_knot(2, 3, 41), flow_parameters()),
            "the state is that of a run with another curve");
  Network pinned = trefoil();
  pinned.set_pinned(5);
  EXPECT_EQ(complaint(pinned, flow_parameters()), "the state is that of a run with another curve");
}

TEST(Run_state, a_run_without_the_certificate_does_not_resume)
{
  Network curve = trefoil();
  const std::vector<double> before = contents(curve);
  const Run_state state = state_of_trefoil();
  Untangling_parameters parameters = flow_parameters();
  parameters.resume_from = &state;
  EXPECT_THROW(untangle(curve, parameters), Run_state_error);
  EXPECT_EQ(contents(curve), before);
}

TEST(Run_state, limits_may_be_others)
{
  Untangling_parameters parameters = flow_parameters();
  const auto whole = run_from(run, trefoil(), parameters, {}, {});
  ASSERT_EQ(whole.result.status, Untangling_status::CONVERGED);
  parameters.number_of_iterations = 2;
  const auto first = run_from(run, trefoil(), parameters, {}, {});
  EXPECT_EQ(first.result.status, Untangling_status::LIMIT);
  parameters.number_of_iterations = 6;
  parameters.time_limit = 1000;
  const auto second = run_from(run, trefoil(), parameters, first.state, {});
  EXPECT_EQ(second.result.status, Untangling_status::LIMIT);
  EXPECT_EQ(second.result.statistics.iterations, 6u);
  parameters.number_of_iterations = 5000;
  expect_same(run_from(run, trefoil(), parameters, second.state, {}), whole);
}

TEST(Run_state, taking_states_changes_nothing)
{
  const Untangling_parameters parameters = flow_parameters();
  Network plain = trefoil(), observed = trefoil();
  untangle(plain, parameters);
  std::size_t number_of_states = 0;
  Untangling_parameters observed_parameters = parameters;
  observed_parameters.checkpoint = [&](const Run_checkpoint& checkpoint) {
    number_of_states += !checkpoint.state().is_empty();
    EXPECT_FALSE(checkpoint.is_last());
  };
  const auto result = untangle(observed, observed_parameters);
  EXPECT_EQ(number_of_states, result.statistics.iterations);
  EXPECT_EQ(contents(plain), contents(observed));
}

TEST(Run_state, named_parameters_take_states)
{
  const auto np = parameters::strategy(Untangling_strategy::FLOW).thickness(0.3);
  Network whole = trefoil(), part = trefoil(), rest = trefoil();
  untangle(whole, np);
  Run_state state;
  untangle(part, np.number_of_iterations(3).checkpoint(
                     [&](const Run_checkpoint& checkpoint) { state = checkpoint.state(); }));
  untangle(rest, np.resume_from(std::cref(state)));
  EXPECT_EQ(contents(rest), contents(whole));
}

} // namespace test_run_state
