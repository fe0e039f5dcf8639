// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LOOKS_UNKNOTTED_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LOOKS_UNKNOTTED_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/knots/Knot_diagram.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The Alexander polynomial of a knot at places of a prime field, where it is a determinant: a minor
// of the matrix of Fox derivatives of the Wirtinger relations, one for each crossing (Crowell and
// Fox 1963). At most cubic in the number of crossings; a hundred take a millisecond.
class Alexander_polynomial
{
  using Number = std::uint64_t; // modulo the prime

public:
  explicit Alexander_polynomial(const Knot_diagram& diagram) : m_diagram(diagram) {}

  // returns its value at t times that at 1 / t, where no unit is left that depends on the diagram
  Number squared_norm(Number t) const { return minor(t) * minor(inverse(t)) % prime; }

private:
  static constexpr Number prime = 2147483647; // 2^31 - 1: products fit
  using Row = std::vector<Number>;

  static Number inverse(Number x)
  {
    Number result = 1;
    for(Number exponent = prime - 2; exponent > 0; exponent /= 2, x = x * x % prime)
      if(exponent % 2 == 1) result = result * x % prime;
    return result;
  }

  Number minor(Number t) const
  {
    const std::size_t n = m_diagram.crossings().size();
    if(n == 0) return 1;
    std::vector<Row> rows(n, Row(n, 0));
    for(std::size_t k = 0; k < n; ++k) {
      const Diagram_crossing& crossing = m_diagram.crossings()[k];
      const auto add = [&](std::size_t arc, Number x) {
        rows[k][arc] = (rows[k][arc] + x) % prime;
      };
      add(crossing.over, 1 + prime - t);
      add(crossing.under_in, crossing.is_positive ? t : prime - 1);
      add(crossing.under_out, crossing.is_positive ? prime - 1 : t);
    }
    rows.pop_back();
    for(Row& row : rows) row.pop_back();
    return determinant(std::move(rows));
  }

  // up to its sign
  static Number determinant(std::vector<Row> rows)
  {
    Number result = 1;
    for(std::size_t k = 0; k < rows.size(); ++k) {
      std::size_t pivot = k;
      while(pivot < rows.size() && rows[pivot][k] == 0) ++pivot;
      if(pivot == rows.size()) return 0;
      std::swap(rows[pivot], rows[k]);
      result = result * rows[k][k] % prime;
      const Number scale = inverse(rows[k][k]);
      for(std::size_t i = k + 1; i < rows.size(); ++i)
        if(rows[i][k] != 0) subtract(rows[k], rows[i][k] * scale % prime, k, rows[i]);
    }
    return result;
  }

  static void subtract(const Row& row, Number factor, std::size_t first, Row& from)
  {
    for(std::size_t k = first; k < row.size(); ++k)
      from[k] = (from[k] + (prime - factor) * row[k]) % prime;
  }

  const Knot_diagram& m_diagram;
};

// Whether a knot has the Alexander polynomial of the unknot, which no other knot of up to 10
// crossings has: then it is likely to be one, which proves nothing. Very large curves do not look
// unknotted, since to look would take longer than a second.
// \pre the curve is a single closed component, and has no garbage
template <typename Network>
bool looks_unknotted(const Network& curve)
{
  constexpr std::size_t most_nodes = 10000, most_crossings = 1000;
  if(curve.number_of_nodes() > most_nodes) return false;
  const Knot_diagram diagram(curve);
  if(diagram.crossings().size() > most_crossings) return false;
  const Alexander_polynomial polynomial(diagram);
  for(const std::uint64_t t : {1234567u, 271828182u}) // no roots of unity of small order
    if(polynomial.squared_norm(t) != 1) return false;
  return true;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LOOKS_UNKNOTTED_H
