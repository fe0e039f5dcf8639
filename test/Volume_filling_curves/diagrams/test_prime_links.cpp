// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The table of prime links: its keys are those of the braid words, and tell these links from all
// others of up to 6 crossings.

#include "support/computed_link_keys.h"

#include <CGAL/Volume_filling_curves/internal/diagrams/Diagram_pieces.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Goeritz_form.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_skein.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_link.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/simplified_diagram.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_prime_links {

namespace VFC = CGAL::Volume_filling_curves;

using namespace VFC::internal;
using namespace knot_test;

std::vector<Named_braid> facts()
{
  return prime_knots(VFC_DATA_DIR "/prime_links.txt");
}

bool is_alternating(const Planar_diagram& diagram)
{
  const Diagram_strands strands(diagram);
  for(std::size_t arc = 0; arc < 2 * diagram.crossings.size(); ++arc)
    if(strands.source(arc).k % 2 == strands.target(arc).k % 2) return false;
  return true;
}

TEST(Prime_links, Braid_words_are_those_of_the_links_with_these_names)
{
  const std::map<std::string, int> determinants{{"2^2_1", 2},  {"4^2_1", 4},  {"5^2_1", 8},
                                                {"6^2_1", 6},  {"6^2_2", 10}, {"6^2_3", 12},
                                                {"6^3_1", 12}, {"6^3_2", 16}, {"6^3_3", 4}};
  ASSERT_EQ(facts().size(), determinants.size());
  for(const auto& [name, braid] : facts()) {
    const Planar_diagram diagram = simplified_diagram(closure(braid));
    EXPECT_EQ(std::to_string(diagram.crossings.size()), name.substr(0, 1)) << name;
    EXPECT_EQ(std::to_string(number_of_components(diagram)), name.substr(2, 1)) << name;
    EXPECT_EQ(Goeritz_form(diagram).determinant(), determinants.at(name)) << name;
    // A reduced alternating diagram in one piece is that of a prime link (Menasco 1984), and has as
    // few crossings as any (Kauffman, Murasugi, Thistlethwaite 1987).
    EXPECT_EQ(diagram_pieces(diagram).diagrams.size(), 1u) << name;
    EXPECT_EQ(is_alternating(diagram), name != "6^3_3") << name;
  }
}

TEST(Prime_links, Keys_are_those_of_the_braid_words)
{
  std::size_t number = 0;
  for(const auto& [name, braid] : facts()) {
    const auto keys = computed_link_keys(closure(braid)),
               mirror_keys = computed_link_keys(closure(mirrored(braid)));
    std::set<std::uint64_t> both = keys;
    both.insert(mirror_keys.begin(), mirror_keys.end());
    const bool is_amphichiral = keys == mirror_keys;
    // all orientations distinguish a chiral link from its mirror image
    EXPECT_EQ(both.size(), is_amphichiral ? keys.size() : keys.size() + mirror_keys.size()) << name;
    for(const std::uint64_t key : both) {
      const auto link = Prime_link::of(Knot_key(key));
      ASSERT_TRUE(link) << name;
      EXPECT_EQ(link->name(), keys.count(key) != 0 ? name : name + '*');
      EXPECT_EQ(link->is_amphichiral(), is_amphichiral) << name;
    }
    number += both.size();
  }
  EXPECT_EQ(number, prime_link_keys.size());
}

// The 2-bridge links 2/1 and 10/3 by Schubert's criterion, 1 = -1 modulo 2 and 9 = -1 modulo 10,
// and the Borromean rings.
TEST(Prime_links, Three_links_are_amphichiral)
{
  std::set<std::string> names;
  for(const Prime_link_key& k : prime_link_keys) {
    const auto link = Prime_link::of(Knot_key(k.key));
    if(link->is_amphichiral()) names.insert(link->name());
  }
  EXPECT_EQ(names, (std::set<std::string>{"2^2_1", "6^2_2", "6^3_2"}));
}

TEST(Prime_links, Keys_differ_between_links)
{
  std::set<std::uint64_t> keys;
  for(const Prime_link_key& k : prime_link_keys) EXPECT_TRUE(keys.insert(k.key).second);
}

struct Factor
{
  std::size_t crossings;
  Knot_key key;
};

// The prime knots and links of the tables, in all orientations, with their mirror images.
std::vector<Factor> prime_factors()
{
  std::vector<Factor> factors;
  for(const auto& [name, braid] : prime_knots(VFC_DATA_DIR "/prime_knots.txt")) {
    const std::size_t crossings = std::stoul(name);
    if(crossings > Prime_link::max_crossings) break; // the others have no fewer
    for(const Braid& b : {braid, mirrored(braid)})
      factors.push_back({crossings, Knot_key::of(homfly_polynomial(closure(b)).value())});
  }
  for(const Prime_link_key& k : prime_link_keys) factors.push_back({k.crossings, Knot_key(k.key)});
  return factors;
}

// HOMFLY-PT of a connected sum is the product, along whatever components; that of a split link has
// another factor.
TEST(Prime_links, Keys_differ_from_those_of_knots_connected_sums_and_split_links)
{
  const auto factors = prime_factors();
  const Knot_key loop = Knot_key::of(Homfly_skein::loop());
  std::size_t number = 0;
  const auto expect_other = [&](const Knot_key& key, std::size_t min_splits) {
    Knot_key split = key;
    for(std::size_t splits = 0; splits <= 3; ++splits, split = split * loop) {
      if(splits < min_splits) continue;
      EXPECT_FALSE(Prime_link::of(split));
      ++number;
    }
  };
  const auto add_factors = [&](const auto& self, const Knot_key& key, std::size_t first,
                               std::size_t crossings, std::size_t n) -> void {
    const bool is_prime_link = n == 1 && Prime_link::of(key).has_value();
    expect_other(key, is_prime_link ? 1 : 0);
    for(std::size_t i = first; i < factors.size(); ++i)
      if(factors[i].crossings <= crossings)
        self(self, key * factors[i].key, i, crossings - factors[i].crossings, n + 1);
  };
  add_factors(add_factors, Knot_key(), 0, Prime_link::max_crossings, 0);
  EXPECT_GT(number, 200u);
}

} // namespace test_prime_links
