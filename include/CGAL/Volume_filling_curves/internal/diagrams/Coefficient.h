// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_COEFFICIENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_COEFFICIENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Coefficients of polynomials: 64-bit integers that throw an exception instead of overflowing.
using Coefficient = std::int64_t;

// Thrown by computations that would exceed 64 bits or their limit of operations.
struct Polynomial_limit : std::runtime_error
{
  Polynomial_limit() : std::runtime_error("a polynomial exceeds the limits") {}
};

// half of the range: sums of two such numbers are in the range
constexpr Coefficient max_coefficient = (std::numeric_limits<Coefficient>::max)() / 2;

inline Coefficient checked(Coefficient c)
{
  if(c > max_coefficient || c < -max_coefficient) throw Polynomial_limit();
  return c;
}

inline Coefficient checked_product(Coefficient c, Coefficient d)
{
  const auto size = [](Coefficient x) { return x < 0 ? -x : x; };
  if(d != 0 && size(c) > max_coefficient / size(d)) throw Polynomial_limit();
  return c * d;
}

// Writes the coefficient of a term after earlier terms: "- 2 " in "1 - 2 x".
inline void write_coefficient(std::ostream& out, Coefficient c, bool is_first, bool is_constant)
{
  out << (c < 0 ? (is_first ? "-" : " - ") : (is_first ? "" : " + "));
  const Coefficient size = c < 0 ? -c : c;
  if(is_constant)
    out << size;
  else if(size != 1)
    out << size << ' ';
}

inline void write_power(std::ostream& out, const char* variable, int exponent)
{
  out << variable;
  if(exponent != 1) out << '^' << exponent;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_COEFFICIENT_H
