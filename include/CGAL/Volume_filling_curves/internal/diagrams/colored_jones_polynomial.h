// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_COLORED_JONES_POLYNOMIAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_COLORED_JONES_POLYNOMIAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Diagram_pieces.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Kauffman_bracket.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Laurent_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Polynomial_work.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Cable of a diagram: each strand is replaced by parallel strands, with the framing of the diagram.
// Each crossing becomes a square grid of crossings with its own arcs.
class Cable
{
public:
  Cable(const Planar_diagram& diagram, std::size_t strands)
      : m_diagram(diagram), m_strands(diagram), m_count(strands)
  {}

  Planar_diagram operator()() const
  {
    Planar_diagram result;
    result.number_of_free_loops = m_count * m_diagram.number_of_free_loops;
    for(std::size_t c = 0; c < m_diagram.crossings.size(); ++c)
      for(std::size_t row = 0; row < m_count; ++row)
        for(std::size_t column = 0; column < m_count; ++column)
          result.crossings.push_back(crossing(c, row, column));
    return result;
  }

private:
  using Arcs = std::array<std::uint32_t, 4>;

  // Lower strands are columns, counted from the left, and upper ones rows, counted from the left of
  // their own direction: from above if they go to the right, which is the positive crossing.
  Arcs crossing(std::size_t c, std::size_t row, std::size_t column) const
  {
    const bool is_positive = m_strands.sign(c) > 0;
    const std::size_t from_below = is_positive ? m_count - 1 - row : row;
    const std::size_t from_in = is_positive ? column : m_count - 1 - column;
    const Arcs& x = m_diagram.crossings[c];
    const std::uint32_t over_in = x[is_positive ? 3 : 1];
    const std::uint32_t lower = arc(x[0], column, from_below), upper = arc(over_in, row, from_in);
    const std::uint32_t lower_out = next(x[0], column, from_below);
    const std::uint32_t upper_out = next(over_in, row, from_in);
    return is_positive ? Arcs{lower, upper_out, lower_out, upper}
                       : Arcs{lower, upper, lower_out, upper_out};
  }

  // The part of a strand of the cable beside an arc, or `step` crossings further in the grid at its
  // end. Arc k has the parts k m ... k m + m - 1 on each of the m strands.
  std::uint32_t arc(std::size_t k, std::size_t strand, std::size_t step) const
  {
    std::size_t component = 0;
    while(m_strands.first_arc(component + 1) <= k) ++component;
    const std::size_t first = m_strands.first_arc(component);
    const std::size_t length = m_strands.first_arc(component + 1) - first;
    return static_cast<std::uint32_t>(m_count * (m_count * first + strand * length + (k - first)) +
                                      step);
  }

  std::uint32_t next(std::size_t k, std::size_t strand, std::size_t step) const
  {
    return step + 1 < m_count ? arc(k, strand, step + 1) : arc(m_strands.next(k), strand, 0);
  }

  const Planar_diagram& m_diagram;
  const Diagram_strands m_strands;
  const std::size_t m_count;
};

inline Planar_diagram cable(const Planar_diagram& diagram, std::size_t strands)
{
  return strands == 1 ? diagram : Cable(diagram, strands)();
}

// Colored Jones polynomials J_c(t) of a knot, J_c(unknot) = 1: those of the representation of
// dimension c + 1. J_1 is the Jones polynomial. They are multiplicative under connected sums. The
// bracket of color c is that of a Chebyshev polynomial of cables (S_1 = z, S_2 = z^2 - 1, S_3 = z^3
// - 2z, where z^k is the k-cable with the framing of the diagram), and a positive curl of the
// framing multiplies it by (-1)^c A^(c^2 + 2c) (Lickorish, An Introduction to Knot Theory, 1997,
// chapters 13 and 14).
class Colored_jones_sweep
{
public:
  explicit Colored_jones_sweep(Polynomial_work& work) : m_work(work) {}

  // in t of a knot; of a link, for color 1 only, in the square root of t
  Laurent_polynomial operator()(const Planar_diagram& diagram, int color)
  {
    const Diagram_pieces pieces = diagram_pieces(diagram);
    auto product = Laurent_polynomial::monomial(0);
    for(const Planar_diagram& piece : pieces.diagrams) product = product * of_piece(piece, color);
    for(std::size_t i = 0; i < pieces.number_of_splits; ++i) product = product * bracket_of_loop(1);
    return product.with_exponents_over(number_of_components(diagram) == 1 ? -4 : -2);
  }

  // The bracket of a loop of a color: (-1)^c (A^2c + A^(2c - 4) + ... + A^-2c).
  static Laurent_polynomial bracket_of_loop(int color)
  {
    Laurent_polynomial sum;
    for(int e = -2 * color; e <= 2 * color; e += 4) sum.add(e, color % 2 == 0 ? 1 : -1);
    return sum;
  }

private:
  // in A
  Laurent_polynomial of_piece(const Planar_diagram& diagram, int color)
  {
    Laurent_polynomial bracket = bracket_of_cable(diagram, color);
    if(color == 2) bracket.add(0, -1);
    if(color == 3) bracket.add_multiple(bracket_of_cable(diagram, 1), 0, -2);
    const int w = internal::writhe(diagram); // not a public one
    Laurent_polynomial unframed;
    unframed.add_multiple(bracket, -w * (color * color + 2 * color),
                          color % 2 != 0 && w % 2 != 0 ? -1 : 1);
    return quotient(unframed, bracket_of_loop(color));
  }

  Laurent_polynomial bracket_of_cable(const Planar_diagram& diagram, int strands)
  {
    return Kauffman_bracket(m_work)(cable(diagram, static_cast<std::size_t>(strands)));
  }

  Polynomial_work& m_work;
};

// Returns the Jones polynomial J_c of color c, from 1 to 3; nothing if it exceeds the limits.
// \pre the diagram is that of a knot if c > 1
// \throws Run_stopped in a Watched_scope
inline std::optional<Laurent_polynomial> colored_jones_polynomial(
    const Planar_diagram& diagram, int color, Polynomial_work work = Polynomial_work())
{
  try {
    return Colored_jones_sweep(work)(diagram, color);
  } catch(const Polynomial_limit&) {
    return std::nullopt;
  }
}

// The Jones polynomial of the 2-cable with framing 0 of a knot, in the square root of t. Since
// z^2 = S_2 + 1, it contains the same information as J_2.
inline Laurent_polynomial jones_of_2_cable(const Laurent_polynomial& colored_jones_2)
{
  Laurent_polynomial bracket =
      colored_jones_2.with_exponents_times(-4) * Colored_jones_sweep::bracket_of_loop(2);
  bracket.add(0, 1);
  return quotient(bracket, Colored_jones_sweep::bracket_of_loop(1)).with_exponents_over(-2);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_COLORED_JONES_POLYNOMIAL_H
