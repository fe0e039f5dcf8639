// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_ALEXANDER_MATRIX_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_ALEXANDER_MATRIX_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Diagram_faces.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_field.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Sparse_determinant.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>

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

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_ALEXANDER_MATRIX_H
