// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/certificate_test_support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_verify_certificate {

using namespace certificate_test;
using Point = Network::Point_3;

// The truth, the guard and the replay on the same changes of the same random curves.
class Three_opinions
{
public:
  explicit Three_opinions(unsigned seed) : m_random(seed) {}

  void compare(std::size_t number_of_curves, std::size_t side, bool is_planar)
  {
    for(std::size_t k = 0; k < number_of_curves; ++k) {
      Network network = to_network(random_curve(side, is_planar, m_random));
      Guard guard(network);
      internal::replay::Certificate_replay replay = replay_of_same_numbers(network);
      EXPECT_NO_THROW(replay.require_embedded());
      for(int change = 0; change < 25; ++change) {
        const Lattice_point place = random_point(side, is_planar, m_random);
        const std::size_t v = below(number_of_node_indices(network), m_random);
        const std::size_t e = below(number_of_edge_indices(network), m_random);
        if(network.is_removed_node(v) || network.is_removed_edge(e)) continue;
        compare_change(network, guard, replay, v, e, place);
        if(testing::Test::HasFatalFailure()) return;
      }
    }
  }

  void expect_both_outcomes(int least) const
  {
    for(const auto& of_kind : m_count)
      for(const int number : of_kind) EXPECT_GT(number, least);
  }

private:
  static internal::replay::Certificate_replay replay_of_same_numbers(const Network& network)
  {
    std::vector<internal::Position> points;
    std::vector<std::array<std::uint64_t, 2>> edges;
    for(std::size_t v = 0; v < network.number_of_nodes(); ++v)
      points.push_back(internal::to_position(network.point(v)));
    for(std::size_t e = 0; e < network.number_of_edges(); ++e)
      edges.push_back({network.source(e), network.target(e)});
    return {points, edges};
  }

  void compare_change(Network& network,
                      Guard& guard,
                      internal::replay::Certificate_replay& replay,
                      std::size_t v,
                      std::size_t e,
                      const Lattice_point& place)
  {
    const Curve before = to_curve(network);
    const auto kind = static_cast<Kind>(below(3, m_random));
    Operation operation = {kind, v, 0, internal::to_position(to_point(place))};
    bool is_true = false, is_certified = false;
    if(kind == Kind::MOVE) {
      is_true = may_move(before, v, place);
      is_certified = guard.move_node(v, to_point(place));
    } else if(kind == Kind::INSERT) {
      operation.node = network.source(e);
      operation.other = network.target(e);
      is_true = may_insert(before, edge_of(before, network, e), place);
      is_certified = guard.insert_node(e, to_point(place));
    } else {
      is_true = may_remove(before, v);
      is_certified = guard.remove_node(v);
    }
    ASSERT_EQ(is_certified, is_true);
    ASSERT_EQ(accepts(replay, operation), is_true);
    ++m_count[static_cast<std::size_t>(kind)][is_true];
  }

  // to_curve() leaves out removed edges
  static std::size_t edge_of(const Curve& curve, const Network& network, std::size_t e)
  {
    for(std::size_t f = 0; f < curve.edges.size(); ++f)
      if(curve.edges[f][0] == network.source(e) && curve.edges[f][1] == network.target(e)) return f;
    return curve.edges.size();
  }

  static bool accepts(internal::replay::Certificate_replay& replay, const Operation& operation)
  {
    try {
      replay(operation);
      return true;
    } catch(const internal::replay::Refusal&) {
      return false;
    }
  }

  Random m_random;
  std::array<std::array<int, 2>, 3> m_count{};
};

TEST(Verify_certificate, decides_as_the_guard_and_brute_force_on_lattices)
{
  Three_opinions opinions(1);
  opinions.compare(1500, 3, false);
  opinions.compare(1000, 5, false);
  opinions.expect_both_outcomes(1000);
}

TEST(Verify_certificate, decides_as_the_guard_and_brute_force_in_the_plane)
{
  Three_opinions opinions(2);
  opinions.compare(1500, 4, true);
  opinions.compare(500, 6, true);
  opinions.expect_both_outcomes(300);
}

Motion random_motion(std::size_t number_of_changes, std::size_t side, Random& random)
{
  Motion motion;
  motion.start = motion.end = to_network(random_curve(side, false, random));
  Guard guard(motion.end);
  guard.start_recording();
  change_at_random(guard, number_of_changes, side, random);
  motion.certificate = guard.certificate();
  return motion;
}

TEST(Verify_certificate, accepts_what_the_guard_has_done)
{
  Random random(3);
  std::set<Kind> kinds;
  for(int k = 0; k < 500; ++k) {
    const Motion motion = random_motion(60, 4, random);
    const Certificate_verdict verdict = motion.verdict();
    EXPECT_TRUE(verdict.is_valid) << verdict.operation << ": " << verdict.message;
    EXPECT_EQ(verdict.operation, 0u);
    const Pieces pieces = take_apart(motion.certificate);
    EXPECT_EQ(verdict.number_of_operations, pieces.operations.size());
    for(const Operation& operation : pieces.operations) kinds.insert(operation.kind);
  }
  EXPECT_EQ(kinds.size(), 3u);
}

// Forged certificates have matching hashes and ends; only the geometry is wrong. Those that are
// right by accident are certificates like others.
TEST(Verify_certificate, decides_as_the_guard_on_forged_certificates)
{
  Random random(4);
  int number_of_accepted = 0, number_of_refused = 0;
  for(int k = 0; k < 3000; ++k) {
    const Motion motion = random_motion(12, 4, random);
    Pieces pieces = take_apart(motion.certificate);
    auto& operations = pieces.operations;
    if(operations.empty()) continue;
    const std::size_t i = below(operations.size(), random), j = below(operations.size(), random);
    switch(below(4, random)) {
    case 0:
      operations.erase(operations.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    case 1:
      std::swap(operations[i], operations[j]);
      break;
    case 2:
      operations[i].node = below(12, random);
      break;
    default:
      operations[i].position = internal::to_position(to_point(random_point(4, false, random)));
    }
    Guard_replay guard(motion.start);
    const std::size_t number = guard(operations);
    const internal::Canonical_curve end(guard.curve());
    pieces.trailer.nodes = end.points().size();
    pieces.trailer.edges = end.edges().size();
    pieces.trailer.curve = end.digest();
    const Certificate_verdict verdict =
        verify_certificate(put_together(pieces), motion.start, guard.curve());
    EXPECT_EQ(verdict.is_valid, number == operations.size()) << verdict.message;
    EXPECT_EQ(verdict.operation, number == operations.size() ? 0 : number + 1) << verdict.message;
    ++(verdict.is_valid ? number_of_accepted : number_of_refused);
  }
  EXPECT_GT(number_of_accepted, 300);
  EXPECT_GT(number_of_refused, 300);
}

// A certificate of a curve that is not embedded proves nothing.
TEST(Verify_certificate, refuses_a_start_that_is_not_embedded)
{
  const auto message = [](Network curve) {
    Guard guard(curve);
    guard.start_recording();
    return verify_certificate(guard.certificate(), curve, curve).message;
  };
  EXPECT_EQ(message({{Point(0, 0, 0), Point(2, 0, 0), Point(1, -1, 0), Point(1, 1, 0)},
                     {{0, 1}, {2, 3}}}),
            "start: edge (1, 2) meets edge (0, 3)");
  EXPECT_EQ(message({{Point(0, 0, 0), Point(2, 0, 0), Point(1, 0, 0)}, {{0, 1}, {1, 2}}}),
            "start: edge (1, 2) meets edge (0, 2)");
  EXPECT_EQ(message({{Point(0, 0, 0), Point(0, 0, 0), Point(1, 0, 0)}, {{0, 1}, {1, 2}}}),
            "start: edge (0, 1) has no length");
  Random random(7);
  for(int k = 0; k < 2000; ++k) {
    Curve curve = random_graph(random);
    for(Lattice_point& p : curve.points) p = random_point(3, k % 2 == 0, random);
    EXPECT_EQ(message(to_network(curve)).empty(), is_embedded(curve));
  }
}

// A caller's own curve: the network, with other nodes.
struct Other_nodes
{
  const Network& network;
  std::vector<std::size_t> listed;
  double shift = 0;

  const std::vector<std::size_t>& nodes() const { return listed; }
  auto edges() const { return network.edges(); }
  Point point(std::size_t v) const
  {
    const Point p = network.point(v);
    return {p.x() + shift, p.y(), p.z()};
  }
  std::size_t source(std::size_t e) const { return network.source(e); }
  std::size_t target(std::size_t e) const { return network.target(e); }
};

TEST(Verify_certificate, takes_nodes_in_any_order_and_refuses_curves_that_make_no_sense)
{
  Network network({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 1)},
                  {{0, 1}, {1, 2}, {2, 3}});
  Guard guard(network);
  guard.start_recording();
  const Isotopy_certificate certificate = guard.certificate();
  for(const std::vector<std::size_t>& order :
      {std::vector<std::size_t>{3, 1, 2, 0}, {0, 3, 1, 2}, {0, 1, 2, 3}})
    EXPECT_TRUE(verify_certificate(certificate, Other_nodes{network, order}, network).is_valid);
  for(const std::vector<std::size_t>& some :
      {std::vector<std::size_t>{0, 1, 2}, {3, 2, 1}, {0, 1, 3}, {}})
    EXPECT_THROW((void)verify_certificate(certificate, Other_nodes{network, some}, network),
                 std::invalid_argument);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(
      (void)verify_certificate(certificate, Other_nodes{network, {0, 1, 2, 3}, infinity}, network),
      std::invalid_argument);
}

TEST(Verify_certificate, is_right_at_the_ends_of_the_range_of_numbers)
{
  Random random(8);
  for(const int exponent : {-960, -500, -300, 300, 480, 490}) {
    for(int k = 0; k < 20; ++k) {
      Motion motion;
      motion.end = to_network(random_curve(4, false, random));
      motion.start = scaled(motion.end, exponent);
      Guard guard(motion.end);
      guard.start_recording();
      change_at_random(guard, 30, 4, random);
      Pieces pieces = take_apart(guard.certificate());
      for(Operation& operation : pieces.operations)
        for(double& x : operation.position) x = std::ldexp(x, exponent);
      pieces.header.curve = internal::Canonical_curve(motion.start).digest();
      motion.end = scaled(motion.end, exponent);
      pieces.trailer.curve = internal::Canonical_curve(motion.end).digest();
      motion.certificate = put_together(pieces);
      EXPECT_TRUE(motion.verdict().is_valid) << exponent << ": " << motion.verdict().message;
    }
  }
}

} // namespace test_verify_certificate
