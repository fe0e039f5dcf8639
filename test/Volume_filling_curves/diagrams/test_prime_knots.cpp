// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The table of prime knots: its keys are those of the braid words, and tell apart all knots and
// connected sums of up to 10 crossings.

#include "support/computed_knot_keys.h"

#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_knot.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace test_prime_knots {

namespace VFC = CGAL::Volume_filling_curves;

using namespace VFC::internal;
using namespace knot_test;

std::vector<Named_braid> facts()
{
  return prime_knots(VFC_DATA_DIR "/prime_knots.txt");
}

// All sorted lists of knots of up to so many crossings together, the empty one included.
void add_sums(std::vector<Prime_knot> factors,
              std::size_t crossings,
              std::vector<std::vector<Prime_knot>>& sums)
{
  sums.push_back(factors);
  for(std::size_t i = 0; i < prime_knot_keys.size(); ++i)
    for(const bool is_mirror : {false, true}) {
      const Prime_knot knot{i, is_mirror};
      if(knot.crossings() > crossings || (!factors.empty() && knot < factors.back())) continue;
      if(is_mirror && knot.is_amphichiral()) continue;
      factors.push_back(knot);
      add_sums(factors, crossings - knot.crossings(), sums);
      factors.pop_back();
    }
}

Knot_key key(const std::vector<Prime_knot>& factors)
{
  Knot_key product;
  for(const Prime_knot& knot : factors) product = product * knot.key();
  return product;
}

TEST(Prime_knots, Names_are_those_of_the_braid_words)
{
  const auto knots = facts();
  ASSERT_EQ(knots.size(), prime_knot_keys.size());
  for(std::size_t i = 0; i < knots.size(); ++i)
    EXPECT_EQ((Prime_knot{i, false}.name()), knots[i].name);
  EXPECT_EQ((Prime_knot{0, true}.name()), "3_1*");
}

TEST(Prime_knots, Keys_are_those_of_the_braid_words)
{
  const auto knots = facts();
  for(std::size_t i = 0; i < knots.size(); ++i)
    for(const bool is_mirror : {false, true}) {
      const Braid braid = is_mirror ? mirrored(knots[i].braid) : knots[i].braid;
      EXPECT_EQ((Prime_knot{i, is_mirror}.key()), computed_key(braid)) << knots[i].name;
    }
}

TEST(Prime_knots, The_third_color_tells_two_knots_from_their_mirror_images)
{
  std::vector<std::string> names;
  for(const Third_knot_key& third : third_knot_keys) {
    const auto knot = facts()[third.knot];
    names.push_back(knot.name);
    EXPECT_EQ(Knot_key(third.keys[0]), computed_third_key(knot.braid));
    EXPECT_EQ(Knot_key(third.keys[1]), computed_third_key(mirrored(knot.braid)));
    EXPECT_NE(third.keys[0], third.keys[1]);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"9_42", "10_71"}));
}

TEST(Prime_knots, Twenty_knots_are_amphichiral)
{
  std::vector<std::string> names;
  for(std::size_t i = 0; i < prime_knot_keys.size(); ++i)
    if(Prime_knot{i, false}.is_amphichiral()) names.push_back(Prime_knot{i, false}.name());
  EXPECT_EQ(names, (std::vector<std::string>{"4_1",   "6_3",    "8_3",    "8_9",    "8_12",
                                             "8_17",  "8_18",   "10_17",  "10_33",  "10_37",
                                             "10_43", "10_45",  "10_79",  "10_81",  "10_88",
                                             "10_99", "10_109", "10_115", "10_118", "10_123"}));
}

TEST(Prime_knots, Keys_differ_for_all_knots_and_connected_sums_of_up_to_10_crossings)
{
  std::vector<std::vector<Prime_knot>> sums;
  add_sums({}, 10, sums);
  EXPECT_GT(sums.size(), 249u + 229u + 50u);
  std::map<Knot_key, std::string> names;
  for(const auto& factors : sums) {
    std::vector<Prime_knot> shown = factors; // without the mirror images that have the same key
    for(Prime_knot& knot : shown)
      if(knot.third_key()) knot.is_mirror = false;
    const auto [known, is_new] = names.emplace(key(shown), knot_name(shown));
    EXPECT_EQ(known->second, knot_name(shown));
    EXPECT_EQ(Prime_factors::of(key(shown), 10).value(), shown) << knot_name(shown);
  }
}

TEST(Prime_knots, Connected_sums_of_more_crossings_are_found_by_their_factors)
{
  const Prime_knot trefoil{0, true}, knot{150, false}, other{200, true};
  for(const auto& factors :
      {std::vector{trefoil, trefoil, trefoil}, {trefoil, knot}, {knot, other}}) {
    EXPECT_EQ(Prime_factors::of(key(factors), 20).value(), factors);
    EXPECT_FALSE(Prime_factors::of(key(factors), 8));
  }
}

TEST(Prime_knots, Keys_of_chiral_sums_differ_from_those_of_their_mirror_images)
{
  std::vector<Prime_knot> chiral; // with their mirror images, which have the inverse ratio
  std::map<Knot_key, Prime_knot> of_ratio;
  for(std::size_t i = 0; i < prime_knot_keys.size(); ++i)
    for(const bool is_mirror : {false, true}) {
      const Prime_knot knot{i, is_mirror};
      if(knot.is_amphichiral() || knot.third_key()) continue;
      chiral.push_back(knot);
      EXPECT_TRUE(of_ratio.emplace(knot.key() * knot.mirrored().key().inverse(), knot).second);
    }
  for(const Prime_knot& first : chiral)
    for(const Prime_knot& second : chiral) {
      if(second == first.mirrored()) continue;
      const Knot_key ratio =
          key({first, second}) * key({first.mirrored(), second.mirrored()}).inverse();
      EXPECT_NE(ratio, Knot_key()) << first.name() << '#' << second.name();
      EXPECT_EQ(of_ratio.count(ratio), 0u) << first.name() << '#' << second.name();
    }
}

TEST(Prime_knots, Other_knots_have_no_factors)
{
  EXPECT_FALSE(Prime_factors::of(computed_key(braid(Braid_word(11, 1))), 20)); // 11a_367
}

} // namespace test_prime_knots
