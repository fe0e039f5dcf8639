// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Knots of open chains: closures, cores, fingerprints and slipknots.

#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_identify_chain {

namespace VFC = CGAL::Volume_filling_curves;

using Network = VFC::Curve_network_3<>;
using Point_3 = Network::Point_3;
using Chain = std::vector<Point_3>;
using VFC::Chain_identity;
using VFC::Chain_section;
using VFC::internal::Vector;
using VFC::internal::Viewing_direction;

// A closed braid without its last edge.
Chain opened_braid(const std::vector<int>& word, std::size_t nodes)
{
  const Network curve = VFC::make_closed_braid(word, nodes, 1);
  Chain chain;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) chain.push_back(curve.point(v));
  return chain;
}

// A trefoil in the middle of a straight rope (Shastri 1992): nodes 15 to 39 of 55.
const Chain& rope()
{
  static const Chain all = [] {
    const auto knot = [](double t, double beyond) {
      const double x = t * t * t - 3 * t, y = t * t * t * t - 4 * t * t,
                   z = std::pow(t, 5) - 10 * t;
      return Point_3(x + beyond * t, y + std::abs(beyond), z + 8 * beyond * t);
    };
    Chain chain;
    for(int k = 15; k > 0; --k) chain.push_back(knot(-2.4, k));
    for(int k = -12; k <= 12; ++k) chain.push_back(knot(0.2 * k, 0));
    for(int k = 1; k <= 15; ++k) chain.push_back(knot(2.4, k));
    return chain;
  }();
  return all;
}

std::vector<Vector> vectors(const Chain& chain)
{
  std::vector<Vector> all;
  for(const Point_3& p : chain) all.push_back(VFC::internal::to_vector(p));
  return all;
}

// The chain with its ends extended far along a direction, and joined there.
Chain closed_far_away(const Chain& chain, const Viewing_direction& d)
{
  constexpr double far = 1e-3; // of directions with a length of 2^20
  Chain closed = chain;
  for(const Point_3& end : {chain.back(), chain.front()})
    closed.emplace_back(end.x() + far * d[0], end.y() + far * d[1], end.z() + far * d[2]);
  closed.push_back(chain.front());
  return closed;
}

Chain reversed(Chain chain)
{
  return {chain.rbegin(), chain.rend()};
}

// A chain that goes back beside itself: the whole has no knot.
Chain there_and_back(const Chain& chain)
{
  Chain all = chain;
  for(const Point_3& p : reversed(chain))
    all.emplace_back(p.x() + 1e-3, p.y() + 2e-3, p.z() + 3e-3);
  return all;
}

TEST(Identify_chain, closures_at_infinity_are_those_of_polygons_with_a_point_far_away)
{
  std::map<std::string, int> names;
  for(const Chain& chain : {rope(), opened_braid({1, -2, 1, -2}, 70), opened_braid({1, 1, 1}, 40)})
    for(const auto& direction : VFC::internal::spread_directions(25, 3)) {
      const auto identity =
          VFC::identify(VFC::internal::diagram_closed_at_infinity(vectors(chain), direction));
      EXPECT_EQ(identity.name, VFC::identify(closed_far_away(chain, direction)).name);
      EXPECT_TRUE(identity.is_proved);
      ++names[identity.name];
    }
  EXPECT_GE(names.size(), 3u); // else the test shows little
}

TEST(Identify_chain, directions_are_spread_evenly_and_depend_on_the_seed)
{
  constexpr double unit = 1 << 20;
  const auto directions = VFC::internal::spread_directions(200, 0);
  Vector sum;
  double least_angle = 4;
  for(const auto& d : directions) {
    const Vector v = Vector(d[0], d[1], d[2]) / unit;
    EXPECT_NEAR(v.norm(), 1, 1e-5);
    sum += v;
    for(const auto& other : directions)
      if(other != d)
        least_angle =
            (std::min)(least_angle, (Vector(other[0], other[1], other[2]) / unit - v).norm());
  }
  EXPECT_LT(sum.norm(), 1);
  EXPECT_GT(least_angle, 0.7 * std::sqrt(4 * 3.14159 / 200)); // side of a square of their area
  EXPECT_EQ(directions, VFC::internal::spread_directions(200, 0));
  EXPECT_NE(directions, VFC::internal::spread_directions(200, 1));
}

TEST(Identify_chain, shares_and_their_errors_follow_from_counts)
{
  const Chain_identity identity =
      VFC::identify_chain(opened_braid({1, 1, 1}, 40), VFC::parameters::closures(80));
  std::size_t closures = 0, last_count = 80;
  for(const VFC::Knot_share& knot : identity.knots) {
    closures += knot.count;
    EXPECT_LE(knot.count, last_count);
    last_count = knot.count;
    EXPECT_DOUBLE_EQ(knot.share, double(knot.count) / 80);
    EXPECT_DOUBLE_EQ(knot.standard_error, std::sqrt(knot.share * (1 - knot.share) / 80));
  }
  EXPECT_EQ(closures, 80u);
  EXPECT_EQ(identity.name, "3_1");
  EXPECT_EQ(identity.direct.name, "3_1");
  EXPECT_TRUE(identity.direct.is_proved);
  EXPECT_TRUE(identity.core.empty());
  EXPECT_TRUE(identity.fingerprint.empty());
}

TEST(Identify_chain, knots_do_not_depend_on_orientation_and_scale_but_on_mirroring)
{
  const auto name = [](const Chain& chain) { return VFC::identify_chain(chain).name; };
  Chain large, mirrored;
  for(const Point_3& p : rope()) {
    large.emplace_back(1024 * p.x(), 1024 * p.y(), 1024 * p.z());
    mirrored.emplace_back(p.x(), p.y(), -p.z());
  }
  const std::string knot = name(rope());
  EXPECT_EQ(knot.substr(0, 3), "3_1");
  EXPECT_EQ(name(large), knot);
  EXPECT_EQ(name(reversed(rope())), knot);
  EXPECT_EQ(name(mirrored), knot == "3_1" ? "3_1*" : "3_1");
}

TEST(Identify_chain, the_core_loses_its_knot_with_a_node_at_either_end)
{
  const auto parameters = VFC::parameters::closures(50).find_core(true);
  const Chain_identity identity = VFC::identify_chain(rope(), parameters);
  ASSERT_EQ(identity.core.size(), 1u);
  EXPECT_EQ(identity.least_interfering.name, identity.name);
  const Chain_section core = identity.core[0];
  EXPECT_EQ(core.name, identity.name);
  EXPECT_GE(core.first, 14u); // the knot is in nodes 15 to 39
  EXPECT_LE(core.last, 40u);
  const auto name = [&](std::size_t first, std::size_t last) {
    const Chain section(rope().begin() + std::ptrdiff_t(first),
                        rope().begin() + std::ptrdiff_t(last) + 1);
    return VFC::identify_chain(section, parameters).name;
  };
  EXPECT_EQ(name(core.first, core.last), identity.name);
  EXPECT_NE(name(core.first + 1, core.last), identity.name);
  EXPECT_NE(name(core.first, core.last - 1), identity.name);
}

TEST(Identify_chain, a_chain_that_undoes_its_knot_has_a_slipknot)
{
  const Chain chain = there_and_back(rope());
  const Chain_identity identity =
      VFC::identify_chain(chain, VFC::parameters::closures(20).stride(8).find_core(true));
  EXPECT_EQ(identity.name, "0_1");
  EXPECT_TRUE(identity.core.empty());
  ASSERT_FALSE(identity.slipknots.empty());
  for(const Chain_section& slipknot : identity.slipknots) {
    EXPECT_EQ(slipknot.name.substr(0, 3), "3_1");
    EXPECT_GT(slipknot.share, 0.5);
    EXPECT_LT(slipknot.last - slipknot.first, rope().size());
  }
}

TEST(Identify_chain, the_fingerprint_lists_all_sections_between_nodes_a_stride_apart)
{
  const Chain chain(rope().begin() + 10, rope().begin() + 33); // nodes 0 to 22
  const Chain_identity identity =
      VFC::identify_chain(chain, VFC::parameters::closures(20).stride(5));
  const std::vector<std::size_t> nodes{0, 5, 10, 15, 20, 22};
  ASSERT_EQ(identity.fingerprint.size(), 15u);
  std::size_t at = 0;
  for(std::size_t i = 0; i < nodes.size(); ++i)
    for(std::size_t k = i + 1; k < nodes.size(); ++k, ++at) {
      EXPECT_EQ(identity.fingerprint[at].first, nodes[i]);
      EXPECT_EQ(identity.fingerprint[at].last, nodes[k]);
    }
  EXPECT_EQ(identity.fingerprint[4].name, identity.name); // the whole
  EXPECT_EQ(identity.fingerprint[4].share, identity.knots[0].share);
  EXPECT_EQ(identity.fingerprint[14].name, "0_1"); // of two edges
  EXPECT_EQ(identity.fingerprint[14].share, 1);
}

TEST(Identify_chain, the_fingerprint_is_the_whole_if_the_stride_is_as_long)
{
  const Chain chain(rope().begin() + 10, rope().begin() + 33);
  for(const std::size_t stride : {std::size_t(22), static_cast<std::size_t>(-1)}) {
    const auto fingerprint =
        VFC::identify_chain(chain, VFC::parameters::closures(5).stride(stride)).fingerprint;
    ASSERT_EQ(fingerprint.size(), 1u);
    EXPECT_EQ(fingerprint[0].last, 22u);
  }
}

TEST(Identify_chain, short_straight_flat_and_lattice_chains_are_closed)
{
  const std::vector<Chain> trivial{{{0, 0, 0}, {1, 0, 0}},
                                   {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                                   {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 2, 0}, {-3, 1, 0}},
                                   {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {4, 2, 1}, {4, 0, 0}},
                                   {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}};
  for(const Chain& chain : trivial) {
    const Chain_identity identity = VFC::identify_chain(chain);
    ASSERT_EQ(identity.knots.size(), 1u);
    EXPECT_EQ(identity.name, "0_1");
    EXPECT_TRUE(identity.knots[0].is_proved);
    const bool is_on_itself = chain.size() < 4 || chain.back() == Point_3(4, 0, 0);
    EXPECT_EQ(identity.direct.name, is_on_itself ? "" : "0_1");
    EXPECT_EQ(identity.least_interfering.name, "0_1");
  }
}

TEST(Identify_chain, what_is_no_open_chain_is_refused)
{
  const Chain crossed{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}};
  EXPECT_THROW((void)VFC::identify_chain(crossed), std::invalid_argument);
  EXPECT_THROW((void)VFC::identify_chain(Chain{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}),
               std::invalid_argument);
  const Network ring(rope(), VFC::parameters::closure(VFC::Closure::CLOSED));
  EXPECT_THROW((void)VFC::identify_chain(ring, 0), std::invalid_argument);
  const Network chain(rope());
  EXPECT_THROW((void)VFC::identify_chain(chain, 1), std::invalid_argument);
  EXPECT_THROW((void)VFC::identify_chain(rope(), VFC::parameters::closures(0)),
               std::invalid_argument);
}

TEST(Identify_chain, progress_can_end_the_run)
{
  int calls = 0;
  const auto progress = [&](const VFC::Run_progress&) { return ++calls < 3; };
  EXPECT_THROW((void)VFC::identify_chain(rope(), VFC::parameters::stride(1).progress(progress)),
               VFC::Run_interrupted);
  EXPECT_EQ(calls, 3);
}

// Both take seconds for millions of nodes.
TEST(Identify_chain, can_end_during_the_check_and_on_the_way_out_of_the_hull)
{
  const Chain crossed{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}};
  const auto end = [](const VFC::Run_progress&) { return false; };
  EXPECT_THROW((void)VFC::identify_chain(crossed, VFC::parameters::progress(end)),
               VFC::Run_interrupted);
  VFC::internal::Run_watch over(0);
  const VFC::internal::Watched_scope scope(&over);
  EXPECT_THROW((void)VFC::internal::minimally_interfering_closure({{0, 0, 0}, {1, 0, 0}}),
               VFC::internal::Run_stopped);
}

using Long_identify_chain = shared_curves::Shared_data_test;

// The knots that KnotProt publishes: 3_1 for 2EFV and 3KZN, 4_1 for 3ULK.
TEST_F(Long_identify_chain, proteins_have_their_published_knots)
{
  struct Protein
  {
    std::string file, name;
    std::size_t nodes_of_core; // at most
  };
  const Protein all[] = {{"2efv.obj", "3_1*", 76},
                         {"3kzn_A.obj", "3_1", 100},
                         {"3ulk.obj", "4_1", 300},
                         {"arc_0_1.obj", "0_1", 0},
                         {"arc_5_2.obj", "5_2*", 400}};
  for(const Protein& protein : all) {
    Network chain;
    ASSERT_TRUE(CGAL::IO::read_curve_network(VFC_SHARED_DATA "/open_arcs/" + protein.file, chain));
    const Chain_identity identity =
        VFC::identify_chain(chain, 0, VFC::parameters::closures(50).find_core(true));
    EXPECT_EQ(identity.name, protein.name) << protein.file;
    EXPECT_EQ(identity.least_interfering.name, protein.name) << protein.file;
    EXPECT_GT(identity.knots[0].share, 0.7) << protein.file;
    for(const Chain_section& core : identity.core)
      EXPECT_LE(core.last - core.first + 1, protein.nodes_of_core) << protein.file;
  }
}

// As of a closed curve whose last point misses the first one by rounding.
TEST(Identify_chain, takes_ends_that_nearly_meet)
{
  for(const double shift : {0., 10.}) {
    Chain chain;
    for(const Point_3& p : opened_braid({1, 1, 1}, 100))
      chain.push_back(Point_3(p.x() + shift, p.y() + shift, p.z() + shift));
    const Point_3 first = chain.front();
    chain.push_back(Point_3(first.x(), std::nextafter(first.y(), 1e9), first.z()));
    EXPECT_EQ(VFC::identify_chain(chain).name, "3_1") << shift;
  }
}

} // namespace test_identify_chain
