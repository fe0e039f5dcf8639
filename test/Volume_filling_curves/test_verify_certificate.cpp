// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "certificate_test_support.h"

#include <CGAL/Volume_filling_curves/internal/generators/braid_closure.h>
#include <CGAL/Volume_filling_curves/internal/generators/hard_unknot.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace certificate_test;
using Point = Network::Point_3;
using vfc::Certificate_verdict;
using vfc::verify_certificate;

// A motion: the curves at both ends and its certificate.
struct Motion
{
  Network start, end;
  Isotopy_certificate certificate;

  Certificate_verdict verdict() const { return verify_certificate(certificate, start, end); }
};

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
        const std::size_t v = below(network.number_of_nodes(), m_random);
        const std::size_t e = below(network.number_of_edges(), m_random);
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
    Operation operation = {kind, v, 0, internal::to_position(to_point(place)), 0};
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
  change_at_random(motion.end, number_of_changes, side, random);
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
  EXPECT_EQ(kinds.size(), 4u);
}

// Forged certificates have hashes that fit, and lead where they say; only the geometry is wrong.
// Those that are right by accident are certificates like others.
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

// A trefoil that is tangled and refined.
Motion tangled_trefoil()
{
  Motion motion;
  motion.start = internal::make_network(
      internal::braid_closure(internal::parse_braid_word("1 1 1"), 36, 0, 1));
  Guard(motion.start).scale_by_power_of_two(-2);
  motion.end = motion.start;
  Guard guard(motion.end);
  guard.start_recording();
  internal::Random_tangler<Network::Traits> tangler(motion.end, 1);
  tangler.tangle(200, 0.5);
  tangler.refine(60);
  tangler.tangle(200, 0.3);
  motion.certificate = guard.certificate();
  return motion;
}

TEST(Verify_certificate, refuses_a_thousand_tamperings)
{
  const Motion motion = tangled_trefoil();
  const std::string bytes = motion.certificate.bytes();
  Random random(5);
  for(int k = 0; k < 1000; ++k) {
    std::string tampered = bytes;
    const std::size_t i = below(bytes.size(), random), j = below(bytes.size(), random);
    switch(k % 5) {
    case 0:
      tampered[i] = static_cast<char>(tampered[i] ^ (1 << below(8, random)));
      break;
    case 1:
      tampered.resize(i);
      break;
    case 2:
      tampered.erase(i, 1 + below(30, random));
      break;
    case 3:
      tampered.insert(i, bytes.substr(j, 1 + below(30, random)));
      break;
    default:
      std::swap(tampered[i], tampered[j]);
    }
    if(tampered == bytes) continue;
    const Certificate_verdict verdict =
        verify_certificate(Isotopy_certificate(tampered), motion.start, motion.end);
    EXPECT_FALSE(verdict.is_valid) << "tampering " << k;
    EXPECT_FALSE(verdict.message.empty());
  }
}

TEST(Verify_certificate, refuses_operations_that_were_dropped_swapped_or_altered)
{
  const Motion motion = tangled_trefoil();
  const Pieces original = take_apart(motion.certificate);
  const std::size_t n = original.operations.size();
  Random random(6);
  int refused_by_geometry = 0;
  for(int k = 0; k < 300; ++k) {
    Pieces pieces = original;
    const std::size_t i = below(n, random), j = below(n, random);
    if(k % 3 == 0) {
      pieces.operations.erase(pieces.operations.begin() + static_cast<std::ptrdiff_t>(i));
    } else if(k % 3 == 1) {
      std::swap(pieces.operations[i], pieces.operations[j]);
    } else {
      double& x = pieces.operations[i].position[below(3, random)];
      x = -x - 0.5;
    }
    // without knowing the hash: what is taken over from the original no longer fits
    std::string bytes = put_together(pieces).bytes();
    bytes.replace(bytes.size() - 32, 32, motion.certificate.bytes(),
                  motion.certificate.bytes().size() - 32, 32);
    if(bytes == motion.certificate.bytes()) continue;
    EXPECT_FALSE(verify_certificate(Isotopy_certificate(bytes), motion.start, motion.end).is_valid);
    // with hashes that fit: right only if the guard thinks so, and it leads to the same end
    const Certificate_verdict verdict =
        verify_certificate(put_together(pieces), motion.start, motion.end);
    Guard_replay guard(motion.start);
    const bool is_right =
        guard(pieces.operations) == pieces.operations.size() &&
        internal::Canonical_curve(guard.curve()).digest() == original.trailer.curve;
    EXPECT_EQ(verdict.is_valid, is_right) << verdict.message;
    if(verdict.operation > 0) ++refused_by_geometry;
  }
  EXPECT_GT(refused_by_geometry, 30);
}

// A triangle beside a rod.
Network triangle_and_rod()
{
  return {{Point(1, -1, 0), Point(1, 1, 0), Point(3, 0, 0), Point(0, 0, -2), Point(0, 0, 2)},
          {{0, 1}, {1, 2}, {2, 0}, {3, 4}}};
}

// An edge of the triangle is bent over the end of the rod, to behind it.
Motion edge_over_the_rod()
{
  Motion motion;
  motion.start = motion.end = triangle_and_rod();
  Guard guard(motion.end);
  guard.start_recording();
  EXPECT_TRUE(guard.insert_node(0, Point(-1, 0, 5)));
  EXPECT_TRUE(guard.move_node(5, Point(-1, 0, 0)));
  motion.certificate = guard.certificate();
  return motion;
}

TEST(Verify_certificate, says_which_operation_is_wrong_and_why)
{
  const Motion motion = edge_over_the_rod();
  EXPECT_TRUE(motion.verdict().is_valid);
  Pieces pieces = take_apart(motion.certificate);
  pieces.operations[0].position = pieces.operations[1].position; // straight through the rod
  pieces.operations.pop_back();
  Certificate_verdict verdict = verify_certificate(put_together(pieces), motion.start, motion.end);
  EXPECT_EQ(verdict.operation, 1u);
  EXPECT_EQ(verdict.message, "inserting a node between 2 and 3: edge (0, 1) is in the way");

  pieces = take_apart(motion.certificate);
  pieces.operations[1].node = 7;
  verdict = verify_certificate(put_together(pieces), motion.start, motion.end);
  EXPECT_EQ(verdict.operation, 2u);
  EXPECT_EQ(verdict.message, "moving node 7: there is no node 7");

  std::string bytes = motion.certificate.bytes();
  bytes.resize(bytes.size() - 100);
  verdict = verify_certificate(Isotopy_certificate(bytes), motion.start, motion.end);
  EXPECT_EQ(verdict.operation, 2u);
  EXPECT_EQ(verdict.message, "the record ends too early");
}

TEST(Verify_certificate, refuses_other_curves)
{
  const Motion motion = edge_over_the_rod();
  const Network other({Point(1, -1, 0), Point(1, 1, 0), Point(3, 0, 0), Point(0, 0, -2),
                       Point(0, 0, std::nextafter(2., 3.))},
                      {{0, 1}, {1, 2}, {2, 0}, {3, 4}});
  EXPECT_EQ(verify_certificate(motion.certificate, other, motion.end).message,
            "start: the certificate starts from another curve");
  EXPECT_EQ(verify_certificate(motion.certificate, motion.start, motion.start).message,
            "end: the certificate leads to another curve");
  EXPECT_EQ(verify_certificate(motion.certificate, motion.end, motion.start).message,
            "start: the certificate starts from another curve");
  EXPECT_FALSE(verify_certificate(motion.certificate, Network(), Network()).is_valid);
}

TEST(Verify_certificate, refuses_what_is_no_certificate_of_this_version)
{
  const Motion motion = edge_over_the_rod();
  const auto message = [&](const std::string& bytes) {
    return verify_certificate(Isotopy_certificate(bytes), motion.start, motion.end).message;
  };
  std::string bytes = motion.certificate.bytes();
  EXPECT_EQ(message(""), "this is no certificate");
  EXPECT_EQ(message("v 0 0 0"), "this is no certificate");
  EXPECT_EQ(message(bytes + '\0'), "there are bytes behind the end of the record");
  bytes[8] = 2;
  EXPECT_EQ(message(bytes), "version 2 of the format is not known");
  EXPECT_EQ(message(with_fitting_hash(bytes).bytes()), "version 2 of the format is not known");
}

TEST(Verify_certificate, refuses_every_flip_of_a_bit)
{
  const Motion motion = edge_over_the_rod();
  std::string bytes = motion.certificate.bytes();
  for(std::size_t i = 0; i < 8 * bytes.size(); ++i) {
    const char before = bytes[i / 8];
    bytes[i / 8] = static_cast<char>(before ^ (1 << i % 8));
    EXPECT_FALSE(verify_certificate(Isotopy_certificate(bytes), motion.start, motion.end).is_valid);
    bytes[i / 8] = before;
  }
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

TEST(Verify_certificate, is_right_at_the_ends_of_the_range_of_numbers)
{
  Random random(8);
  for(const int exponent : {-960, -500, -300, 300, 480, 960}) {
    for(int k = 0; k < 20; ++k) {
      Motion motion;
      motion.start = motion.end = to_network(random_curve(4, false, random));
      Guard(motion.start).scale_by_power_of_two(exponent);
      Guard guard(motion.end);
      guard.start_recording();
      change_at_random(motion.end, 30, 4, random);
      Pieces pieces = take_apart(guard.certificate());
      for(Operation& operation : pieces.operations)
        for(double& x : operation.position) x = std::ldexp(x, exponent);
      pieces.header.curve = internal::Canonical_curve(motion.start).digest();
      ASSERT_TRUE(Guard(motion.end).scale_by_power_of_two(exponent));
      pieces.trailer.curve = internal::Canonical_curve(motion.end).digest();
      motion.certificate = put_together(pieces);
      EXPECT_TRUE(motion.verdict().is_valid) << exponent << ": " << motion.verdict().message;
    }
  }
}

TEST(Verify_certificate, refuses_scalings_that_are_not_exact)
{
  const Motion motion = edge_over_the_rod();
  for(const std::int64_t exponent :
      {1023l, 1024l, -1075l, 1l << 40, std::numeric_limits<long>::min()}) {
    Pieces pieces = take_apart(motion.certificate);
    pieces.operations.push_back({Kind::SCALE, 0, 0, {}, exponent});
    const auto verdict = verify_certificate(put_together(pieces), motion.start, motion.end);
    EXPECT_EQ(verdict.operation, 3u);
    EXPECT_EQ(verdict.message, "scaling by two to the power of " + std::to_string(exponent) +
                                   ": scaling would not be exact");
  }
}

} // namespace
