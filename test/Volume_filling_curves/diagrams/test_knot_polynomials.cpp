// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// HOMFLY-PT and colored Jones polynomials of closed braids, against closed forms, against the skein
// relation crossing by crossing, and against each other.

#include "support/braid_diagrams.h"

#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/colored_jones_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace test_knot_polynomials {

namespace VFC = CGAL::Volume_filling_curves;

using namespace VFC::internal;
using namespace knot_test;
using VFC::Planar_diagram;

std::string text(const std::optional<Laurent_polynomial>& p)
{
  std::ostringstream out;
  p.value().write(out, "t");
  return out.str();
}

std::string text(const std::optional<Laurent_polynomial_2>& p)
{
  std::ostringstream out;
  p.value().write(out, {"v", "z"});
  return out.str();
}

std::string homfly(const Braid& braid)
{
  return text(homfly_polynomial(closure(braid)));
}

std::string jones(const Braid& braid, int color = 1)
{
  return text(colored_jones_polynomial(closure(braid), color));
}

// The number of components, after a walk along the closure that asks visit(letter, is_over) at each
// pass and ends if that is false.
template <typename Visit>
std::optional<std::size_t> walk(const Braid& braid, Visit visit)
{
  std::vector<bool> is_seen(braid.strands, false);
  std::size_t components = 0;
  for(std::size_t start = 0; start < braid.strands; ++start) {
    if(is_seen[start]) continue;
    ++components;
    for(std::size_t strand = start; !is_seen[strand];) {
      is_seen[strand] = true;
      for(std::size_t i = 0; i < braid.word.size(); ++i) {
        const int letter = braid.word[i];
        const auto left = static_cast<std::size_t>(std::abs(letter) - 1);
        if(strand != left && strand != left + 1) continue;
        const bool is_left = strand == left;
        if(!visit(i, is_left == (letter > 0))) return std::nullopt;
        strand = is_left ? left + 1 : left;
      }
    }
  }
  return components;
}

// The polynomial by the skein relation: the first crossing that is passed below first is switched,
// and smoothed; a descending diagram is a trivial link.
Laurent_polynomial_2 skein_polynomial(const Braid& braid)
{
  std::vector<bool> is_passed(braid.word.size(), false);
  std::size_t wrong = 0;
  const auto components = walk(braid, [&](std::size_t i, bool is_over) {
    wrong = i;
    if(!is_passed[i] && !is_over) return false;
    is_passed[i] = true;
    return true;
  });
  Laurent_polynomial_2 sum;
  if(components) {
    sum = Laurent_polynomial_2::monomial({0, 0});
    for(std::size_t i = 1; i < *components; ++i) sum = sum * Homfly_skein::loop();
    return sum;
  }
  Braid switched = braid, smoothed = braid;
  const int sign = braid.word[wrong] > 0 ? 1 : -1;
  switched.word[wrong] = -switched.word[wrong];
  smoothed.word.erase(smoothed.word.begin() + static_cast<std::ptrdiff_t>(wrong));
  sum.add_multiple(skein_polynomial(switched), {2 * sign, 0});
  sum.add_multiple(skein_polynomial(smoothed), {sign, 1}, sign);
  return sum;
}

// The polynomial that v = t, z = t^(1/2) - t^(-1/2) makes of the HOMFLY-PT polynomial, which is the
// Jones polynomial; in t^(1/2), times z^power, which must make all exponents of z positive.
Laurent_polynomial jones_of_homfly(const Laurent_polynomial_2& p, int power)
{
  auto z = Laurent_polynomial::monomial(1);
  z.add(-1, -1);
  Laurent_polynomial sum;
  for(const auto& term : p.terms()) {
    auto product = Laurent_polynomial::monomial(2 * term.exponents[0], term.coefficient);
    for(int i = 0; i < term.exponents[1] + power; ++i) product = product * z;
    sum.add_multiple(product, 0);
  }
  for(int i = 0; i < power; ++i) sum = quotient(sum, z);
  return sum;
}

// The closure of (1 2 ... p-1)^q.
Braid torus_braid(int p, int q)
{
  Braid_word word;
  for(int i = 0; i < q; ++i)
    for(int letter = 1; letter < p; ++letter) word.push_back(letter);
  return braid(word);
}

TEST(Knot_polynomials, Small_knots_and_links_have_the_published_polynomials)
{
  EXPECT_EQ(homfly(braid({1, 1, 1})), "2 v^2 + v^2 z^2 - v^4"); // the right-handed trefoil
  EXPECT_EQ(homfly(braid({1, -2, 1, -2})), "v^-2 - 1 - z^2 + v^2");
  EXPECT_EQ(homfly(braid({1, 1})), "v z^-1 + v z - v^3 z^-1"); // Hopf's link, linking number 1
  EXPECT_EQ(jones(braid({1, 1, 1})), "t + t^3 - t^4");
  EXPECT_EQ(jones(braid({1, -2, 1, -2})), "t^-2 - t^-1 + 1 - t + t^2");
  EXPECT_EQ(jones(braid({1, 1})), "-t - t^5"); // in the square root of t
}

TEST(Knot_polynomials, Unknots_and_unlinks_have_the_polynomials_of_loops)
{
  EXPECT_EQ(text(homfly_polynomial({{}, 1})), "1");
  EXPECT_EQ(text(homfly_polynomial({{}, 3})), "v^-2 z^-2 - 2 z^-2 + v^2 z^-2");
  EXPECT_EQ(text(colored_jones_polynomial({{}, 2}, 1)), "-t^-1 - t");
  for(const Braid& unknot : {braid({1}), braid({-1, 2, -3}), braid({1, -1, 1, 2})}) {
    EXPECT_EQ(homfly(unknot), "1");
    for(int color : {1, 2, 3}) EXPECT_EQ(jones(unknot, color), "1");
  }
  EXPECT_EQ(homfly({4, {1, -3}}), homfly({2, {}})); // two diagrams side by side
}

TEST(Knot_polynomials, Torus_knots_follow_the_closed_form)
{
  for(const auto& [p, q] : {std::pair(2, 3), {2, 9}, {3, 4}, {3, 5}, {3, 7}, {4, 5}, {5, 6}}) {
    auto numerator = Laurent_polynomial::monomial((p - 1) * (q - 1) / 2);
    numerator.add((p - 1) * (q - 1) / 2 + p + 1, -1);
    numerator.add((p - 1) * (q - 1) / 2 + q + 1, -1);
    numerator.add((p - 1) * (q - 1) / 2 + p + q, 1);
    auto denominator = Laurent_polynomial::monomial(0);
    denominator.add(2, -1);
    EXPECT_EQ(jones(torus_braid(p, q)), text(quotient(numerator, denominator))) << p << ' ' << q;
    EXPECT_EQ(homfly(torus_braid(p, q)), homfly(torus_braid(q, p))) << p << ' ' << q;
  }
}

TEST(Knot_polynomials, Homfly_follows_the_skein_relation_crossing_by_crossing)
{
  std::mt19937 random(1);
  for(std::size_t i = 0; i < 300; ++i) {
    const Braid braid = random_braid(2 + i % 5, 1 + random() % 11, random);
    const Planar_diagram diagram = closure(braid);
    ASSERT_TRUE(is_planar_diagram(diagram));
    EXPECT_EQ(homfly_polynomial(diagram), skein_polynomial(braid))
        << testing::PrintToString(braid.word);
  }
}

TEST(Knot_polynomials, Jones_is_a_value_of_homfly)
{
  std::mt19937 random(2);
  for(std::size_t i = 0; i < 100; ++i) {
    const Planar_diagram diagram = closure(random_braid(3 + i % 4, 20 + random() % 20, random));
    const std::size_t components = number_of_components(diagram);
    const auto expected = jones_of_homfly(homfly_polynomial(diagram).value(), 8);
    const auto jones = colored_jones_polynomial(diagram, 1).value();
    EXPECT_EQ(jones.with_exponents_times(components == 1 ? 2 : 1), expected) << i;
  }
}

TEST(Knot_polynomials, Color_2_knows_the_jones_polynomial_of_the_2_cable)
{
  // without twists the cable of the diagram has framing 0 if the writhe is 0
  for(const Braid& braid : {braid({1, -2, 1, -2}), braid({1, 1, 1, -2, -3, -4}), braid({1, -2})}) {
    const Planar_diagram diagram = closure(braid);
    ASSERT_EQ(VFC::internal::writhe(diagram), 0);
    const Planar_diagram doubled = cable(diagram, 2);
    ASSERT_TRUE(is_planar_diagram(doubled));
    const auto expected = jones_of_homfly(homfly_polynomial(doubled).value(), 4);
    EXPECT_EQ(jones_of_2_cable(colored_jones_polynomial(diagram, 2).value()), expected);
  }
}

TEST(Knot_polynomials, A_mirror_image_inverts_the_variables)
{
  std::mt19937 random(3);
  for(int i = 0; i < 20; ++i) {
    const Braid word = random_braid(4, 15, random);
    const Planar_diagram diagram = closure(word);
    EXPECT_EQ(colored_jones_polynomial(mirror(diagram), 1),
              colored_jones_polynomial(diagram, 1).value().with_exponents_times(-1));
    EXPECT_EQ(homfly_polynomial(mirror(diagram)), homfly_polynomial(closure(mirrored(word))));
  }
}

TEST(Knot_polynomials, Reidemeister_moves_keep_them)
{
  std::mt19937 random(4);
  const Braid knot = braid({1, 1, 2, -1, -3, 2, -3}); // 6_1
  for(int i = 0; i < 10; ++i) {
    const Braid moved = with_random_moves(knot, 8, random);
    EXPECT_EQ(homfly(moved), homfly(knot)) << testing::PrintToString(moved.word);
    for(int color : {1, 2}) EXPECT_EQ(jones(moved, color), jones(knot, color));
  }
}

TEST(Knot_polynomials, Connected_sums_multiply_them)
{
  const Braid trefoil = braid({1, 1, 1}), figure_eight = braid({1, -2, 1, -2});
  const Planar_diagram sum = closure(connected_sum(trefoil, figure_eight));
  const Planar_diagram first = closure(trefoil), second = closure(figure_eight);
  EXPECT_EQ(homfly_polynomial(sum), *homfly_polynomial(first) * *homfly_polynomial(second));
  for(int color : {1, 2, 3})
    EXPECT_EQ(colored_jones_polynomial(sum, color),
              *colored_jones_polynomial(first, color) * *colored_jones_polynomial(second, color));
}

TEST(Knot_polynomials, A_limit_of_work_ends_without_a_polynomial)
{
  const Planar_diagram diagram = closure(torus_braid(4, 9));
  EXPECT_FALSE(homfly_polynomial(diagram, Polynomial_work(100)));
  EXPECT_FALSE(colored_jones_polynomial(diagram, 2, Polynomial_work(100)));
  EXPECT_TRUE(homfly_polynomial(diagram));
}

TEST(Knot_polynomials, A_run_that_is_to_stop_ends_them)
{
  const Planar_diagram diagram = closure(torus_braid(4, 9));
  const Planar_diagram sum = closure(connected_sum({2, {1, 1, 1}}, {2, {1, 1, 1}}));
  Run_watch over(0);
  const Watched_scope scope(&over);
  EXPECT_THROW((void)homfly_polynomial(diagram), Run_stopped);
  EXPECT_THROW((void)colored_jones_polynomial(diagram, 2), Run_stopped);
  EXPECT_THROW((void)diagram_pieces(sum), Run_stopped);
  const auto spend = [](Polynomial_work& work) {
    for(int i = 0; i < 1000; ++i) work.use(1);
  };
  Polynomial_work work;
  EXPECT_THROW(spend(work), Run_stopped);
}

} // namespace test_knot_polynomials
