// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_ALEXANDER_POLYNOMIAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_ALEXANDER_POLYNOMIAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Chinese_remainders.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Diagram_faces.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_field.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Sparse_determinant.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>

#include <CGAL/Exact_integer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Alexander polynomial of a link at points of prime fields: the determinant of the matrix with a
// row for each crossing and a column for each face except two adjacent ones (Alexander 1928). Its
// value is that of the polynomial times a unit, plus or minus a power of t, which only depends on
// the diagram. For a split link it is 0.
class Alexander_matrix
{
public:
  using Number = Prime_field::Number;

  // \pre is_planar_diagram(diagram)
  explicit Alexander_matrix(const Planar_diagram& diagram)
      : m_faces(diagram),
        m_size(diagram.crossings.size()),
        m_is_split(m_faces.number_of_parts() + diagram.number_of_free_loops > 1)
  {
    for(std::size_t face = 0, column = 0; face < m_faces.number_of_faces(); ++face) {
      const bool is_left_out = face == m_faces.face(0, 0) || face == m_faces.face(0, 1);
      m_columns.push_back(is_left_out ? none : column++);
    }
  }

  // an upper bound of the degree of value() as a polynomial in t
  std::size_t max_degree() const { return m_size; }

  // \throws Run_stopped in a Watched_scope
  Number value(Number t, const Prime_field& field) const
  {
    if(m_is_split) return 0;
    Sparse_determinant determinant(m_size, field);
    const Number coefficients[4] = {1, field.negative(1), t, field.negative(t)}; // of the corners
    for(std::size_t c = 0; c < m_size; ++c)
      for(std::size_t k = 0; k < 4; ++k) {
        const std::size_t column = m_columns[m_faces.face(c, k)];
        if(column != none) determinant.add(c, column, coefficients[k]);
      }
    return determinant();
  }

  // Its value at t times that at 1 / t, which depends on the link only. \pre t is not 0
  Number squared_norm(Number t, const Prime_field& field) const
  {
    return field.product(value(t, field), value(field.inverse(t), field));
  }

private:
  static constexpr std::size_t none = ~std::size_t(0);

  Diagram_faces m_faces;
  std::size_t m_size;
  bool m_is_split;
  std::vector<std::size_t> m_columns; // of each face; none for two
};

// Arguments modulo the largest prime below 2^31; no roots of unity of small order.
inline constexpr std::uint64_t alexander_arguments[] = {1234567, 271828182};

// Returns whether a knot seems to have the Alexander polynomial of the unknot, by its values at two
// points of a prime field. If not, the knot is proved knotted; otherwise nothing is proved,
// although no nontrivial knot of up to 10 crossings has this polynomial.
// \throws Run_stopped in a Watched_scope
inline bool has_trivial_alexander_polynomial(const Planar_diagram& diagram)
{
  const Alexander_matrix matrix(diagram);
  const Prime_field field;
  for(const std::uint64_t t : alexander_arguments)
    if(matrix.squared_norm(t, field) != 1) return false;
  return true;
}

// Returns whether the Alexander polynomial of a knot is that of the unknot, as far as two values
// show; false for curves too large to test within a second, which proves nothing about them.
// \pre the curve is a single closed component, and has no garbage
template <typename Network>
bool looks_like_small_unknot(const Network& curve)
{
  constexpr std::size_t max_nodes = 10000, max_crossings = 1000;
  if(curve.number_of_nodes() > max_nodes) return false;
  const Planar_diagram diagram = best_diagram(closed_polygons(curve), 1);
  return diagram.crossings.size() <= max_crossings && has_trivial_alexander_polynomial(diagram);
}

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
