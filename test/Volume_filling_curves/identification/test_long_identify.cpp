// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Names of knots and unknots in random conformations, and before and after they are untangled.

#include "support/braid_diagrams.h"
#include "support/flow_test_support.h"
#include "support/shared_curves.h"
#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace test_long_identify {

namespace VFC = CGAL::Volume_filling_curves;

using namespace knot_test;
using VFC::Knottedness;
using VFC::Link_identity;
using Network = VFC::Curve_network_3<>;

constexpr std::uint64_t number_of_conformations = 20;

void expect_unknotted(const Network& curve)
{
  const Link_identity identity = VFC::identify(curve);
  EXPECT_EQ(identity.name, "0_1");
  EXPECT_TRUE(identity.is_proved);
  EXPECT_EQ(identity.knottedness, Knottedness::UNKNOTTED);
}

// The name of a curve that is proved to be knotted; empty for others.
std::string name_of_knotted(const Network& curve)
{
  const Link_identity identity = VFC::identify(curve);
  const bool is_knotted = identity.knottedness != Knottedness::UNKNOWN &&
                          identity.knottedness != Knottedness::UNKNOTTED;
  return is_knotted && identity.is_proved ? identity.name : "";
}

// Moves nodes by at most 5 % of the distance between strands: no strand passes through another one.
Network jittered(const Network& curve, unsigned seed)
{
  flow_test::Random random(seed);
  const double most = 0.05 * VFC::min_clearance(curve);
  std::vector<Network::Point_3> points;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    const VFC::internal::Vector step = flow_test::random_point(random) / std::sqrt(3.);
    EXPECT_LE(step.norm(), 1);
    const VFC::internal::Vector p = VFC::internal::to_vector(curve.point(v)) + most * step;
    points.emplace_back(p.x(), p.y(), p.z());
  }
  return Network(points, VFC::parameters::closure(VFC::Closure::CLOSED));
}

TEST(Long_identify, All_prime_knots_are_named_in_five_random_conformations)
{
  std::mt19937 random(1);
  for(const auto& [name, braid] : prime_knots(VFC_DATA_DIR "/prime_knots.txt"))
    for(const bool is_mirror : {false, true})
      for(std::size_t seed = 0; seed < 5; ++seed) {
        const Braid moved = with_random_moves(is_mirror ? mirrored(braid) : braid, 4, random);
        const auto curve = VFC::make_closed_braid(moved.word, 800, seed, moved.strands);
        const Link_identity identity = VFC::identify(curve);
        const bool is_starred = is_mirror && identity.chirality == VFC::Knot_chirality::CHIRAL;
        EXPECT_EQ(identity.name, is_starred ? name + '*' : name);
        EXPECT_TRUE(identity.is_proved) << name;
      }
}

TEST(Long_identify, The_unknot_is_unknotted_in_random_conformations)
{
  for(std::uint64_t seed = 0; seed < number_of_conformations; ++seed)
    expect_unknotted(untangle_test::tangled(VFC::make_regular_polygon(100), seed));
}

using Long_identify_shared_curves = shared_curves::Shared_data_test;

TEST_F(Long_identify_shared_curves, Hakens_unknot_is_unknotted_in_random_conformations)
{
  Network haken;
  ASSERT_TRUE(CGAL::IO::read_curve_network(VFC_SHARED_DATA "/paper/haken.obj", haken));
  for(std::uint64_t seed = 0; seed < number_of_conformations; ++seed)
    expect_unknotted(untangle_test::tangled(haken, seed));
}

TEST_F(Long_identify_shared_curves, Jittered_knots_keep_their_names_when_they_are_untangled)
{
  const auto knots = shared_curves::known_curves({"knot128"});
  ASSERT_GE(knots.size(), 128u);
  for(std::size_t k = 8; k < knots.size(); k += 16)
    for(const unsigned seed : {1u, 2u}) {
      const std::string& file = knots[k].file;
      Network curve;
      ASSERT_TRUE(CGAL::IO::read_curve_network(knots[k].path(), curve)) << file;
      curve = jittered(curve, seed);
      const std::string name = name_of_knotted(curve);
      EXPECT_EQ(name.substr(0, name.find('*')), knots[k].type) << file;
      VFC::untangle(curve, VFC::parameters::stop_at_proof(false).lower_ropelength(true));
      EXPECT_EQ(name_of_knotted(curve), name) << file;
    }
}

} // namespace test_long_identify
