// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"
#include "support/knot_invariants.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/alexander_polynomial.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>

// Which knots look like unknots.
namespace test_looks_like_small_unknot {

using namespace flow_test;
using CGAL::Volume_filling_curves::make_closed_braid;
using CGAL::Volume_filling_curves::make_hard_unknot;
using CGAL::Volume_filling_curves::make_random_polygon;
using CGAL::Volume_filling_curves::make_torus_knot;
using CGAL::Volume_filling_curves::parse_braid_word;

bool looks_like_small_unknot(const std::string& word)
{
  return internal::looks_like_small_unknot(make_closed_braid(parse_braid_word(word), 200, 0, 1));
}

TEST(Looks_like_small_unknot, holds_for_unknots)
{
  EXPECT_TRUE(internal::looks_like_small_unknot(internal::closed_network({circle(30)})));
  EXPECT_TRUE(looks_like_small_unknot("1 2 -3 4"));
  for(std::uint64_t seed = 0; seed < 10; ++seed)
    EXPECT_TRUE(internal::looks_like_small_unknot(make_hard_unknot(300, 40, seed))) << seed;
}

TEST(Looks_like_small_unknot, does_not_hold_for_knots)
{
  for(const std::string word : {"1 1 1", "-1 -1 -1", "1 -2 1 -2", "1 1 1 1 1", "1 1 1 2 -1 2"})
    EXPECT_FALSE(looks_like_small_unknot(word)) << word;
  EXPECT_FALSE(internal::looks_like_small_unknot(make_torus_knot(5, 3, 200))); // of determinant 1
}

// Kinoshita and Terasaka's knot: nobody sees it by this polynomial.
TEST(Looks_like_small_unknot, holds_for_knots_with_a_trivial_polynomial)
{
  EXPECT_TRUE(looks_like_small_unknot("1 1 1 3 3 2 -3 -1 -1 2 -1 -3 -2"));
}

TEST(Looks_like_small_unknot, agrees_with_another_computation)
{
  std::size_t number_of_unknots = 0;
  for(std::uint64_t seed = 0; seed < 100; ++seed) {
    const Network curve = make_random_polygon(100, seed);
    const auto values =
        knot_test::alexander_values(knot_test::diagram_of(knot_test::loops_of(curve)));
    const bool is_trivial = values == knot_test::Alexander_values{1, 1, 1};
    EXPECT_EQ(internal::looks_like_small_unknot(curve), is_trivial) << seed;
    number_of_unknots += is_trivial;
  }
  EXPECT_GT(number_of_unknots, 5u);
  EXPECT_LT(number_of_unknots, 90u);
}

} // namespace test_looks_like_small_unknot
