// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_ALEXANDER_POLYNOMIAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_ALEXANDER_POLYNOMIAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Alexander_matrix.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Chinese_remainders.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_field.h>

#include <CGAL/Exact_integer.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Coefficients, from the lowest power, of the polynomial of degree below n with given values at 0,
// 1, ..., n - 1, by Newton's divided differences. Quadratic time.
inline std::vector<Prime_field::Number> interpolation(std::vector<Prime_field::Number> values,
                                                      const Prime_field& field)
{
  const std::size_t n = values.size();
  for(std::size_t order = 1; order < n; ++order) {
    const Prime_field::Number scale = field.inverse(order);
    for(std::size_t k = n - 1; k >= order; --k)
      values[k] = field.product(field.difference(values[k], values[k - 1]), scale);
  }
  std::vector<Prime_field::Number> result(n, 0);
  for(std::size_t k = n; k-- > 0;) { // result = result * (t - k) + values[k]
    for(std::size_t i = n - 1; i > 0; --i)
      result[i] = field.difference(result[i - 1], field.product(k, result[i]));
    result[0] = field.difference(values[k], field.product(k, result[0]));
  }
  return result;
}

// Coefficients of the Alexander polynomial, from the lowest power: the first one is not 0, and
// their sum is 1 for a knot; for a link the first one is positive. None if the polynomial is 0, as
// for a split link. Every row of the matrix has norm 2 on the unit circle, which bounds them
// (Hadamard). O(n^2.5) operations modulo each of n / 31 primes: 0.7 s for 257 crossings.
// \throws Run_stopped in a Watched_scope
inline std::vector<Exact_integer> alexander_polynomial(const Planar_diagram& diagram)
{
  const Alexander_matrix matrix(diagram);
  const std::size_t n = matrix.max_degree() + 1;
  Chinese_remainders remainders(n, static_cast<double>(n));
  while(!remainders.is_complete()) {
    std::vector<Prime_field::Number> values(n);
    for(std::size_t t = 0; t < n; ++t) values[t] = matrix.value(t, remainders.field());
    remainders.add(interpolation(std::move(values), remainders.field()));
  }
  std::vector<Exact_integer> result = remainders.values();
  const auto is_zero = [](const Exact_integer& x) { return x == 0; };
  while(!result.empty() && is_zero(result.back())) result.pop_back();
  result.erase(result.begin(), std::find_if_not(result.begin(), result.end(), is_zero));
  Exact_integer sum(0);
  for(const Exact_integer& x : result) sum += x;
  if(sum < 0 || (sum == 0 && !result.empty() && result.front() < 0))
    for(Exact_integer& x : result) x = -x;
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_ALEXANDER_POLYNOMIAL_H
