// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Diagrams that get simpler: they stay planar, and keep invariants that are computed independently.

#include "support/knot_invariants.h"
#include "support/planar_diagrams.h"
#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/simplified_diagram.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_simplified_diagram {

namespace VFC = CGAL::Volume_filling_curves;
using namespace VFC::internal;
using namespace knot_test;

struct Known
{
  std::size_t components;
  Alexander_values alexander;
  int signature;
  std::vector<int> linking; // of all pairs, in order

  explicit Known(const Planar_diagram& planar)
  {
    const Diagram diagram = plain_diagram(planar);
    components = diagram.number_of_components;
    alexander = alexander_values(diagram);
    signature = knot_test::signature(diagram);
    for(const auto& row : linking_numbers(diagram))
      linking.insert(linking.end(), row.begin(), row.end());
    std::sort(linking.begin(), linking.end());
  }

  friend bool operator==(const Known& a, const Known& b)
  {
    return a.components == b.components && a.alexander == b.alexander &&
           a.signature == b.signature &&
           std::equal(std::find_if(a.linking.begin(), a.linking.end(), [](int x) { return x; }),
                      a.linking.end(),
                      std::find_if(b.linking.begin(), b.linking.end(), [](int x) { return x; }),
                      b.linking.end());
  }
};

Planar_diagram random_diagram(std::size_t nodes, std::uint64_t seed)
{
  return best_diagram(closed_polygons(VFC::make_random_polygon(nodes, seed)), 1);
}

TEST(Simplified_diagram, Known_knots_come_to_their_crossing_number)
{
  const std::vector<std::pair<std::string, std::size_t>> words{
      {"1 -1 2 -2", 0},         {"1 1 1", 3},
      {"1 -2 1 -2", 4},         {"1 1 1 2 -1 2", 5},
      {"1 2 1 2 1 2 1 2", 8},   {"1 1 1 2 -1 2 -3 -3 -3 -3", 9},
      {"1 1 1 2 2 2 1 1 1", 9}, {"1 2 -1 2 1 -2 -1 -2", 0}};
  for(const auto& [word, crossings] : words) {
    const Planar_diagram diagram = braid_diagram(word);
    const Planar_diagram simple = simplified_diagram(diagram);
    EXPECT_TRUE(is_planar_diagram(simple));
    EXPECT_TRUE(Known(simple) == Known(diagram)) << word;
    EXPECT_LE(simple.crossings.size(), crossings) << word;
  }
}

// Every single move is looked at.
TEST(Simplified_diagram, Moves_keep_the_link)
{
  for(std::uint64_t seed = 0; seed < 10; ++seed) {
    const Planar_diagram start = random_diagram(60, seed);
    const Known known(start);
    Editable_diagram diagram(start);
    Strand_rerouting rerouting(diagram);
    Random_source random(seed);
    for(int k = 0; k < 300 && diagram.number_of_crossings() > 0; ++k) {
      const auto s = static_cast<Editable_diagram::Slot>(random.index(diagram.number_of_slots()));
      if(!diagram.is_used(s) || !diagram.is_outgoing(s)) continue;
      const bool is_moved = k % 5 == 0 ? rerouting.shorten(s, 1 + random.index(8))
                                       : rerouting.move_at_random(s, 1 + random.index(8), random);
      if(!is_moved) continue;
      const Planar_diagram now = diagram.planar_diagram();
      ASSERT_TRUE(is_planar_diagram(now)) << seed << ' ' << k;
      ASSERT_TRUE(Known(now) == known) << seed << ' ' << k;
    }
  }
}

TEST(Simplified_diagram, Random_knots_keep_their_invariants)
{
  for(std::uint64_t seed = 0; seed < 40; ++seed) {
    const Planar_diagram diagram = random_diagram(150, seed);
    const Planar_diagram simple = simplified_diagram(diagram);
    EXPECT_TRUE(is_planar_diagram(simple));
    EXPECT_TRUE(Known(simple) == Known(diagram)) << seed;
    EXPECT_LT(simple.crossings.size(), diagram.crossings.size() / 2);
  }
}

TEST(Simplified_diagram, Links_keep_their_components)
{
  for(const std::string word : {"1 1", "1 1 2 2", "1 -2 1 -2 1 -2", "1 -2 1 -2 -2", "1 1 -1 -1",
                                "1 1 1 1", "1 -1 2 3 3 -2 -3 -3", "1 2 3 1 2 3 1 2 3 1 2 3"}) {
    const Planar_diagram diagram = braid_diagram(word);
    const Planar_diagram simple = simplified_diagram(diagram);
    EXPECT_TRUE(is_planar_diagram(simple));
    EXPECT_TRUE(Known(simple) == Known(diagram)) << word;
  }
}

TEST(Simplified_diagram, Components_above_or_below_all_others_are_lifted)
{
  const Planar_diagram circle_on_circle{{{0, 2, 1, 3}, {1, 2, 0, 3}}, 0};
  for(const auto& diagram : {circle_on_circle, mirror(circle_on_circle)}) {
    const Planar_diagram simple = simplified_diagram(diagram);
    EXPECT_TRUE(simple.crossings.empty());
    EXPECT_EQ(simple.number_of_free_loops, 2u);
  }
}

TEST(Simplified_diagram, Large_diagrams_shrink_in_a_second)
{
  const Planar_diagram diagram = random_diagram(2000, 1);
  const Planar_diagram simple = simplified_diagram(diagram);
  EXPECT_GT(diagram.crossings.size(), 2000u);
  EXPECT_LT(simple.crossings.size(), diagram.crossings.size() / 10);
  EXPECT_TRUE(is_planar_diagram(simple));
}

TEST(Long_simplified_diagram, Random_moves_end_in_diagrams_with_large_faces)
{
  std::string word;
  for(int k = 0; k < 2001; ++k) word += "1 ";
  Diagram_simplification simplification(braid_diagram(word));
  simplification.shorten_strands();
  EXPECT_FALSE(simplification.is_work_done());
  Random_source random(0);
  simplification.shake(1000, random);
  EXPECT_TRUE(simplification.is_work_done());
  EXPECT_EQ(simplification.number_of_crossings(), 2001u);
}

using Shared_knots = shared_curves::Shared_data_test;

TEST_F(Shared_knots, Come_to_at_most_ten_crossings)
{
  for(const auto& known : shared_curves::known_curves({"knot128", "trefoil100", "trefoil_hard"})) {
    VFC::Curve_network_3<> curve;
    ASSERT_TRUE(CGAL::IO::read_curve_network(known.path(), curve));
    const Planar_diagram simple = simplified_diagram(best_diagram(closed_polygons(curve), 3));
    EXPECT_LE(simple.crossings.size(), 10u) << known.file;
  }
}

} // namespace test_simplified_diagram
