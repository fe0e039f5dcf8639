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
#include <CGAL/Volume_filling_curves/internal/diagrams/cable.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Colored Jones polynomials J_c(t) of a knot, J_c(unknot) = 1: those of the representation of
// dimension c + 1. J_1 is the Jones polynomial. They are multiplicative under connected sums. The
// bracket of color c is that of a Chebyshev polynomial of cables (S_1 = z, S_2 = z^2 - 1, S_3 = z^3
// - 2z, where z^k is the k-cable with the framing of the diagram), and a positive curl of the
// framing multiplies it by (-1)^c A^(c^2 + 2c) (Lickorish, An Introduction to Knot Theory, 1997,
// chapters 13 and 14).
class Colored_jones_sweep
{
public:
  explicit Colored_jones_sweep(std::size_t work) : m_work(work) {}

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
    Kauffman_bracket bracket(m_work);
    Laurent_polynomial result = bracket(cable(diagram, static_cast<std::size_t>(strands)));
    m_work = bracket.work_left();
    return result;
  }

  std::size_t m_work;
};

// Returns the Jones polynomial J_c of color c, from 1 to 3; nothing if it exceeds the limit of
// operations on coefficients. \pre the diagram is that of a knot if c > 1
inline std::optional<Laurent_polynomial> colored_jones_polynomial(const Planar_diagram& diagram,
                                                                  int color,
                                                                  std::size_t work = default_work)
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
