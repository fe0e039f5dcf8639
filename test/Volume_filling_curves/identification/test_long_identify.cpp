// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Names of all prime knots of up to 10 crossings and their mirror images, in random conformations.

#include "support/braid_diagrams.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>

namespace test_long_identify {

namespace VFC = CGAL::Volume_filling_curves;

using namespace knot_test;

TEST(Long_identify, All_prime_knots_are_named_in_five_random_conformations)
{
  std::mt19937 random(1);
  for(const auto& [name, braid] : prime_knots(VFC_DATA_DIR "/prime_knots.txt"))
    for(const bool is_mirror : {false, true})
      for(std::size_t seed = 0; seed < 5; ++seed) {
        const Braid moved = with_random_moves(is_mirror ? mirrored(braid) : braid, 4, random);
        const auto curve = VFC::make_closed_braid(moved.word, 800, seed, moved.strands);
        const VFC::Link_identity identity = VFC::identify(curve);
        const bool is_starred = is_mirror && identity.chirality == VFC::Knot_chirality::CHIRAL;
        EXPECT_EQ(identity.name, is_starred ? name + '*' : name);
        EXPECT_TRUE(identity.is_proved) << name;
      }
}

} // namespace test_long_identify
