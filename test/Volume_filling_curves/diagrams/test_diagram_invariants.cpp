// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Alexander polynomial, determinant and signature: known values, an independent computation, and
// relations between the three.

#include "support/knot_invariants.h"
#include "support/planar_diagrams.h"

#include <CGAL/Volume_filling_curves/internal/diagrams/Goeritz_form.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/alexander_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/simplified_diagram.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_diagram_invariants {

namespace VFC = CGAL::Volume_filling_curves;
using namespace VFC::internal;
using namespace knot_test;
using CGAL::Exact_integer;

std::vector<std::int64_t> coefficients(const Planar_diagram& diagram)
{
  std::vector<std::int64_t> result;
  for(const Exact_integer& x : VFC::internal::alexander_polynomial(diagram))
    result.push_back(static_cast<std::int64_t>(CGAL::to_double(x)));
  return result;
}

struct Known_knot
{
  std::string word;
  std::vector<std::int64_t> alexander;
  int determinant, signature;
};

TEST(Diagram_invariants, Have_the_values_of_the_tables)
{
  const std::vector<Known_knot> known{
      {"1 -2", {1}, 1, 0},                                            // the unknot
      {"1 1 1", {1, -1, 1}, 3, -2},                                   // 3_1
      {"-1 -1 -1", {1, -1, 1}, 3, 2},                                 // its mirror image
      {"1 -2 1 -2", {-1, 3, -1}, 5, 0},                               // 4_1
      {"1 1 1 1 1", {1, -1, 1, -1, 1}, 5, -4},                        // 5_1
      {"1 1 1 2 -1 2", {2, -3, 2}, 7, -2},                            // 5_2
      {"1 2 1 2 1 2 1 2", {1, -1, 0, 1, 0, -1, 1}, 3, -6},            // 8_19
      {"1 2 1 2 1 2 1 2 1 2", {1, -1, 0, 1, -1, 1, 0, -1, 1}, 1, -8}, // 10_124
      {"1 1 1 2 2 2", {1, -2, 3, -2, 1}, 9, -4},                      // 3_1 # 3_1
      {"1 1 1 -2 -2 -2", {1, -2, 3, -2, 1}, 9, 0},                    // 3_1 # mirror image
      {"1 1 1 3 3 2 -3 -1 -1 2 -1 -3 -2", {1}, 1, 0},                 // Kinoshita-Terasaka
      {"1 1", {1, -1}, 2, -1}};                                       // Hopf link
  for(const Known_knot& knot : known)
    for(std::size_t direction = 0; direction < 3; ++direction) {
      const Planar_diagram diagram = braid_diagram(knot.word, direction);
      EXPECT_EQ(coefficients(diagram), knot.alexander) << knot.word;
      EXPECT_EQ(Goeritz_form(diagram).determinant(), knot.determinant) << knot.word;
      EXPECT_EQ(Goeritz_form(diagram).signature(), knot.signature) << knot.word;
    }
}

TEST(Diagram_invariants, Agree_with_another_computation)
{
  for(std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto curve = VFC::make_random_polygon(80, seed);
    const Planar_diagram planar = best_diagram(closed_polygons(curve), 1);
    const Diagram diagram = plain_diagram(planar);
    EXPECT_EQ(alexander_values(coefficients(planar)), alexander_values(diagram)) << seed;
    EXPECT_EQ(Goeritz_form(planar).determinant(), Exact_integer(long(determinant(diagram))));
    EXPECT_EQ(Goeritz_form(planar).signature(), signature(diagram)) << seed;
  }
}

// Alexander(1) = 1, symmetry, |Alexander(-1)| is the determinant, and its sign is that of the
// signature modulo 4 (Murasugi).
TEST(Diagram_invariants, Of_knots_fit_together)
{
  for(std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto curve = VFC::make_random_polygon(150, seed);
    const Planar_diagram diagram = simplified_diagram(best_diagram(closed_polygons(curve), 1));
    const auto polynomial = VFC::internal::alexander_polynomial(diagram);
    ASSERT_EQ(polynomial.size() % 2, 1u);
    EXPECT_TRUE(std::equal(polynomial.begin(), polynomial.end(), polynomial.rbegin()));
    Exact_integer at_one(0), at_minus_one(0);
    for(std::size_t k = 0; k < polynomial.size(); ++k) {
      at_one += polynomial[k];
      const bool is_minus = (k + polynomial.size() / 2) % 2 == 1; // the middle one is that of t^0
      at_minus_one += is_minus ? Exact_integer(-polynomial[k]) : polynomial[k];
    }
    EXPECT_EQ(at_one, 1);
    const Goeritz_form form(diagram);
    const int sign = form.signature() % 4 == 0 ? 1 : -1;
    EXPECT_EQ(at_minus_one, form.determinant() * sign) << seed;
  }
}

TEST(Diagram_invariants, Split_links_have_no_polynomial)
{
  const Planar_diagram two_loops{{}, 2};
  // two trefoils side by side
  const Planar_diagram two_trefoils{
      {{0, 3, 1, 4}, {2, 5, 3, 0}, {4, 1, 5, 2}, {6, 9, 7, 10}, {8, 11, 9, 6}, {10, 7, 11, 8}}, 0};
  for(const auto& diagram : {two_loops, two_trefoils, braid_diagram("1 1 1 3 3 3")}) {
    EXPECT_TRUE(VFC::internal::alexander_polynomial(diagram).empty());
    EXPECT_EQ(Goeritz_form(diagram).determinant(), 0);
  }
  EXPECT_EQ(Goeritz_form(two_trefoils).signature(), 4);
}

TEST(Diagram_invariants, Signatures_change_sign_with_the_mirror_image)
{
  for(std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto curve = VFC::make_random_polygon(100, seed);
    const Planar_diagram diagram = best_diagram(closed_polygons(curve), 1);
    EXPECT_EQ(Goeritz_form(mirror(diagram)).signature(), -Goeritz_form(diagram).signature());
  }
}

// The closure of (1 -2)^n has the determinant L_2n - 2, with the numbers of Lucas.
TEST(Diagram_invariants, Determinants_are_exact_however_large)
{
  std::string word;
  Exact_integer lucas(1), next(3); // L_1 and L_2
  for(int k = 0; k < 100; ++k) word += "1 -2 ";
  for(int k = 2; k < 200; ++k) {
    const Exact_integer sum = lucas + next;
    lucas = next;
    next = sum;
  }
  EXPECT_EQ(Goeritz_form(braid_diagram(word)).determinant(), next - 2);
}

} // namespace test_diagram_invariants
