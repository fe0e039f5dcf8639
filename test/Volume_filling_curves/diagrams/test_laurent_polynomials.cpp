// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Polynomials in one and two variables and their inverses.

#include <CGAL/Volume_filling_curves/internal/diagrams/Laurent_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Laurent_polynomial_2.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_laurent_polynomials {

namespace VFC = CGAL::Volume_filling_curves;

using namespace VFC::internal;

Laurent_polynomial polynomial(const std::vector<std::pair<int, Coefficient>>& terms)
{
  Laurent_polynomial p;
  for(const auto& [exponent, coefficient] : terms) p.add(exponent, coefficient);
  return p;
}

std::string text(const Laurent_polynomial& p)
{
  std::ostringstream out;
  p.write(out, "t");
  return out.str();
}

std::string text(const Laurent_polynomial_2& p)
{
  std::ostringstream out;
  p.write(out, {"v", "z"});
  return out.str();
}

TEST(Laurent_polynomial, Terms_are_written_with_rising_exponents)
{
  EXPECT_EQ(text(polynomial({{1, 1}, {4, -1}, {3, 1}})), "t + t^3 - t^4");
  EXPECT_EQ(text(polynomial({{0, -1}, {-2, -3}, {1, 2}})), "-3 t^-2 - 1 + 2 t");
  EXPECT_EQ(text(Laurent_polynomial()), "0");
}

TEST(Laurent_polynomial, Terms_that_cancel_vanish)
{
  const auto p = polynomial({{-3, 2}, {0, 1}, {5, 7}, {-3, -2}, {5, -7}});
  EXPECT_EQ(p, Laurent_polynomial::monomial(0));
  EXPECT_EQ(p.low(), 0);
  EXPECT_EQ(p.end(), 1);
  EXPECT_TRUE(polynomial({{4, 1}, {4, -1}}).is_zero());
  EXPECT_EQ(polynomial({{4, 1}, {4, -1}}), Laurent_polynomial());
}

TEST(Laurent_polynomial, A_product_divided_by_a_factor_is_the_other_one)
{
  const auto p = polynomial({{-2, 3}, {0, -1}, {7, 4}}), q = polynomial({{-5, 2}, {-1, -1}});
  EXPECT_EQ(text(p * q), "6 t^-7 - 2 t^-5 - 3 t^-3 + t^-1 + 8 t^2 - 4 t^6");
  EXPECT_EQ(quotient(p * q, q), p);
}

TEST(Laurent_polynomial, Exponents_can_be_multiplied_and_divided)
{
  const auto p = polynomial({{-2, 3}, {1, -1}});
  EXPECT_EQ(text(p.with_exponents_times(-4)), "-t^-4 + 3 t^8");
  EXPECT_EQ(p.with_exponents_times(-4).with_exponents_over(-4), p);
}

TEST(Laurent_polynomial, An_overflow_is_an_exception)
{
  auto p = Laurent_polynomial::monomial(0, max_coefficient);
  EXPECT_THROW(p.add(0, 1), Polynomial_limit);
  EXPECT_THROW(p * Laurent_polynomial::monomial(1, 2), Polynomial_limit);
  EXPECT_EQ((p * Laurent_polynomial::monomial(1, -1))[1], -max_coefficient);
  const auto q = Laurent_polynomial_2::monomial({0, 0}, max_coefficient);
  EXPECT_THROW(q * Laurent_polynomial_2::monomial({0, 1}, 2), Polynomial_limit);
}

TEST(Laurent_polynomial_2, Terms_are_written_with_rising_exponents)
{
  Laurent_polynomial_2 p = Laurent_polynomial_2::monomial({4, 0}, -1);
  p.add_multiple(Laurent_polynomial_2::monomial({2, 2}));
  p.add_multiple(Laurent_polynomial_2::monomial({2, 0}, 2));
  EXPECT_EQ(text(p), "2 v^2 + v^2 z^2 - v^4");
  p.add_multiple(p, {0, 0}, -1);
  EXPECT_EQ(text(p), "0");
  EXPECT_EQ(text(Laurent_polynomial_2::monomial({0, -1}, -2)), "-2 z^-1");
  EXPECT_EQ(text(Laurent_polynomial_2::monomial({0, 0})), "1");
}

TEST(Laurent_polynomial_2, Products_distribute_over_sums)
{
  const auto u = Laurent_polynomial_2::monomial({-1, -1}),
             w = Laurent_polynomial_2::monomial({1, -1});
  Laurent_polynomial_2 loop = u;
  loop.add_multiple(w, {0, 0}, -1);
  EXPECT_EQ(text(loop * loop), "v^-2 z^-2 - 2 z^-2 + v^2 z^-2");
  loop.shift({1, 1});
  EXPECT_EQ(text(loop), "1 - v^2");
}

} // namespace test_laurent_polynomials
