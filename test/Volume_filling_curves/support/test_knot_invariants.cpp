// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/csv_cells.h"
#include "support/jones_polynomial.h"
#include "support/knot_invariants.h"

#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace test_knot_invariants {

namespace generators = CGAL::Volume_filling_curves::internal;
using CGAL::Volume_filling_curves::parse_braid_word;
using knot_test::Laurent;
using knot_test::Loop;
using Coefficients = std::vector<std::int64_t>;
using Matrix = std::vector<std::vector<int>>;

std::vector<Loop> loops(const generators::Polygons& polygons)
{
  return knot_test::loops_of(generators::closed_network(polygons));
}

std::vector<Loop> braid(const std::string& word, std::size_t strands = 1)
{
  return loops(generators::braid_closure(parse_braid_word(word), 200, 0, strands));
}

std::vector<Loop> torus(int p, int q)
{
  return loops(generators::torus_knot(p, q, 200));
}

struct Known_knot
{
  std::string name, word;
  Coefficients alexander;
  std::uint64_t determinant;
  int signature; // negative for positive braids
  Laurent jones;
};

const std::vector<Known_knot> known_knots{
    {"0_1", "1 2", {1}, 1, 0, {{0, 1}}},
    {"3_1", "1 1 1", {1, -1, 1}, 3, -2, {{2, 1}, {6, 1}, {8, -1}}},
    {"4_1", "1 -2 1 -2", {1, -3, 1}, 5, 0, {{-4, 1}, {-2, -1}, {0, 1}, {2, -1}, {4, 1}}},
    {"5_1", "1 1 1 1 1", {1, -1, 1, -1, 1}, 5, -4, {{4, 1}, {8, 1}, {10, -1}, {12, 1}, {14, -1}}},
    {"5_2",
     "1 1 1 2 -1 2",
     {2, -3, 2},
     7,
     -2,
     {{2, 1}, {4, -1}, {6, 2}, {8, -1}, {10, 1}, {12, -1}}},
    {"granny",
     "1 1 1 2 2 2",
     {1, -2, 3, -2, 1},
     9,
     -4,
     {{4, 1}, {8, 2}, {10, -2}, {12, 1}, {14, -2}, {16, 1}}},
    {"square",
     "1 1 1 -2 -2 -2",
     {1, -2, 3, -2, 1},
     9,
     0,
     {{-6, -1}, {-4, 1}, {-2, -1}, {0, 3}, {2, -1}, {4, 1}, {6, -1}}},
    {"8_19", "1 2 1 2 1 2 1 2", {1, -1, 0, 1, 0, -1, 1}, 3, -6, {{6, 1}, {10, 1}, {16, -1}}}};

TEST(Knot_invariants, of_known_knots)
{
  for(const Known_knot& knot : known_knots) {
    const auto invariants = knot_test::invariants_of(braid(knot.word));
    EXPECT_EQ(invariants.alexander, knot_test::alexander_values(knot.alexander)) << knot.name;
    EXPECT_EQ(invariants.determinant, knot.determinant) << knot.name;
    EXPECT_EQ(invariants.signature, knot.signature) << knot.name;
    EXPECT_EQ(knot_test::jones_polynomial(knot_test::diagram_of(braid(knot.word))), knot.jones)
        << knot.name;
  }
}

TEST(Knot_invariants, change_with_the_mirror_image_as_they_should)
{
  for(const Known_knot& knot : known_knots) {
    const auto mirror = knot_test::mirrored(braid(knot.word));
    const auto invariants = knot_test::invariants_of(mirror);
    EXPECT_EQ(invariants.alexander, knot_test::alexander_values(knot.alexander)) << knot.name;
    EXPECT_EQ(invariants.signature, -knot.signature) << knot.name;
    Laurent jones;
    for(const auto& [exponent, coefficient] : knot.jones) jones[-exponent] = coefficient;
    EXPECT_EQ(knot_test::jones_polynomial(knot_test::diagram_of(mirror)), jones) << knot.name;
  }
}

TEST(Knot_invariants, do_not_depend_on_the_projection)
{
  for(const auto& curve :
      {torus(2, 3), torus(3, 5), braid("1 1 -2 1 -2"), loops(generators::random_polygon(300, 1)),
       loops(generators::lattice_polygon(500, 4))}) {
    const auto expected = knot_test::invariants_of(curve);
    int directions = 0;
    for(unsigned k = 20; k < 26; ++k) {
      const knot_test::Projection projection(curve, k);
      if(!projection.is_generic()) continue;
      ++directions;
      const auto diagram = projection.diagram();
      EXPECT_EQ(knot_test::alexander_values(diagram), expected.alexander);
      EXPECT_EQ(knot_test::determinant(diagram), expected.determinant);
      for(bool is_black : {false, true})
        EXPECT_EQ(knot_test::signature(diagram, is_black), expected.signature);
      EXPECT_EQ(knot_test::linking_numbers(diagram), expected.linking_numbers);
    }
    EXPECT_GT(directions, 3);
  }
}

TEST(Knot_invariants, of_torus_knots)
{
  EXPECT_EQ(knot_test::invariants_of(torus(2, 3)), knot_test::invariants_of(braid("1 1 1")));
  EXPECT_EQ(knot_test::invariants_of(torus(2, -3)), knot_test::invariants_of(braid("-1 -1 -1")));
  EXPECT_EQ(knot_test::invariants_of(torus(3, 4)), knot_test::invariants_of(torus(4, 3)));
  EXPECT_EQ(knot_test::invariants_of(torus(1, 5)), knot_test::invariants_of(braid("")));
  EXPECT_EQ(knot_test::invariants_of(torus(3, 5)).signature, -8);
  EXPECT_EQ(knot_test::invariants_of(torus(2, 9)).determinant, 9u);
}

TEST(Knot_invariants, of_links)
{
  const auto hopf = knot_test::invariants_of(braid("1 1"));
  EXPECT_EQ(hopf.linking_numbers, (Matrix{{0, 1}, {1, 0}}));
  EXPECT_EQ(hopf.determinant, 2u);
  EXPECT_EQ(hopf.alexander, knot_test::alexander_values(Coefficients{-1, 1}));
  const auto whitehead = knot_test::invariants_of(braid("1 1 -2 1 -2"));
  EXPECT_EQ(whitehead.determinant, 8u);
  EXPECT_EQ(whitehead.linking_numbers, (Matrix{{0, 0}, {0, 0}}));
  EXPECT_EQ(whitehead.alexander, knot_test::alexander_values(Coefficients{1, -3, 3, -1}));
  EXPECT_EQ(knot_test::invariants_of(braid("1 -2 1 -2 1 -2")).determinant, 16u); // Borromean rings
}

TEST(Knot_invariants, of_unlinks)
{
  const auto unlink = braid("", 3);
  EXPECT_EQ(knot_test::invariants_of(unlink).determinant, 0u);
  EXPECT_EQ(knot_test::invariants_of(unlink).linking_numbers, Matrix(3, std::vector<int>(3, 0)));
  EXPECT_EQ(knot_test::jones_polynomial(knot_test::diagram_of(unlink)),
            (Laurent{{-2, 1}, {0, 2}, {2, 1}}));
}

std::vector<Loop> moved(std::vector<Loop> curve, double x)
{
  for(Loop& loop : curve)
    for(knot_test::Point& p : loop) p[0] += x;
  return curve;
}

std::vector<Loop> together(std::vector<Loop> curves, const std::vector<Loop>& others)
{
  curves.insert(curves.end(), others.begin(), others.end());
  return curves;
}

TEST(Knot_invariants, of_components_far_apart)
{
  const auto circle = braid(""), kinks = moved(braid("1 2 -3"), 1e3), trefoil = braid("1 1 1");
  ASSERT_EQ(knot_test::Projection(circle, 0).diagram().crossings.size(), 0u);
  const knot_test::Diagram diagram = knot_test::Projection(together(circle, kinks), 0).diagram();
  ASSERT_EQ(diagram.number_of_components_without_crossings(), 1u);
  ASSERT_GT(diagram.crossings.size(), 0u);
  for(const auto& curve :
      {together(circle, kinks), together(kinks, circle), together(trefoil, moved(circle, 1e3)),
       together(trefoil, moved(knot_test::mirrored(trefoil), 1e3)),
       together(together(circle, kinks), moved(kinks, -1e4))}) {
    const auto invariants = knot_test::invariants_of(curve);
    EXPECT_EQ(invariants.determinant, 0u);
    EXPECT_EQ(invariants.alexander, knot_test::Alexander_values{});
    const std::size_t n = curve.size();
    EXPECT_EQ(invariants.linking_numbers, Matrix(n, std::vector<int>(n, 0)));
  }
}

// The signature adds up, the Jones polynomial is the product and a circle's bracket.
TEST(Knot_invariants, of_split_links)
{
  const auto trefoil = braid("1 1 1"), circle = moved(braid(""), 1e3);
  const auto other = moved(braid("1 1 1"), 1e3), mirror = moved(knot_test::mirrored(trefoil), 1e3);
  EXPECT_EQ(knot_test::invariants_of(together(trefoil, circle)).signature, -2);
  EXPECT_EQ(knot_test::invariants_of(together(trefoil, other)).signature, -4);
  EXPECT_EQ(knot_test::invariants_of(together(trefoil, mirror)).signature, 0);
  const auto jones = [](const std::vector<Loop>& curve) {
    return knot_test::jones_polynomial(knot_test::diagram_of(curve));
  };
  EXPECT_EQ(jones(together(trefoil, circle)), (Laurent{{1, -1}, {3, -1}, {5, -1}, {9, 1}}));
  EXPECT_EQ(jones(together(circle, trefoil)), jones(together(trefoil, circle)));
}

TEST(Knot_invariants, of_lattice_polygons_are_those_of_the_unknot)
{
  for(std::uint64_t seed = 1; seed < 6; ++seed)
    EXPECT_EQ(knot_test::invariants_of(loops(generators::lattice_polygon(400, seed))),
              knot_test::invariants_of(braid("1")));
}

// A closed component's record repeats its first index.
std::vector<Loop> read_obj(const std::string& name)
{
  std::vector<knot_test::Point> points;
  std::vector<Loop> result;
  std::ifstream in(name);
  for(std::string line, key; std::getline(in, line);) {
    std::istringstream stream(line);
    if(!(stream >> key)) continue;
    if(key == "v") {
      knot_test::Point p;
      stream >> p[0] >> p[1] >> p[2];
      points.push_back(p);
    } else if(key == "l") {
      result.emplace_back();
      for(std::size_t i; stream >> i;) result.back().push_back(points.at(i - 1));
      result.back().pop_back();
    }
  }
  return result;
}

TEST(Knot_invariants, agree_with_the_manifest_of_the_shared_data)
{
  std::ifstream manifest(std::string(VFC_SHARED_DATA) + "/MANIFEST.csv");
  if(!manifest) GTEST_SKIP() << "the shared data are not here";
  std::string line;
  std::getline(manifest, line);
  const std::vector<std::string> names = csv_cells(line);
  int number = 0;
  for(int row = 0; std::getline(manifest, line); ++row) {
    const std::vector<std::string> fields = csv_cells(line);
    const auto field = [&](const std::string& name) {
      std::size_t i = 0;
      while(names.at(i) != name) ++i;
      return fields.at(i);
    };
    const bool is_link = field("set") == "links";
    if(field("closed") != "1" || (row % 20 != 0 && !is_link)) continue;
    const auto curve = read_obj(std::string(VFC_SHARED_DATA) + "/" + field("file"));
    ASSERT_FALSE(curve.empty()) << field("file");
    const auto invariants = knot_test::invariants_of(curve);
    EXPECT_EQ(std::to_string(invariants.determinant), field("determinant")) << field("file");
    std::istringstream alexander(field("alexander"));
    Coefficients coefficients;
    for(std::int64_t c; alexander >> c;) coefficients.push_back(c);
    EXPECT_EQ(invariants.alexander, knot_test::alexander_values(coefficients)) << field("file");
    if(field("type") == "3_1") {
      // of a right-handed trefoil the signature is negative, and the exponents are positive
      EXPECT_EQ(invariants.signature, field("jones").find("x^-") == std::string::npos ? -2 : 2)
          << field("file");
    }
    if(is_link) {
      std::ostringstream linking;
      for(const auto& numbers : invariants.linking_numbers)
        for(int n : numbers) linking << n << ' ';
      std::string expected;
      for(char c : field("linking"))
        if(c == ',')
          expected += ' ';
        else if(c != '[' && c != ']' && c != ' ')
          expected += c;
      EXPECT_EQ(linking.str(), expected + " ") << field("file");
    }
    ++number;
  }
  EXPECT_GT(number, 10);
}

} // namespace test_knot_invariants
