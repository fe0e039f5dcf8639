// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KNOTTEDNESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KNOTTEDNESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_skein.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/alexander_polynomial.h>

#include <cstddef>
#include <cstdint>
#include <ostream>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesKnots
/// \headerfile CGAL/Volume_filling_curves/identify.h
///
/// Proofs that a knot or link is trivial or not.
enum class Knottedness
{
  UNKNOWN,                         ///< no proof
  UNKNOTTED,                       ///< a trivial link: all crossings can be removed
  LINKED_BY_LINKING_NUMBER,        ///< two components have a linking number other than 0
  KNOTTED_BY_DETERMINANT,          ///< the determinant is not that of the trivial link
  KNOTTED_BY_ALEXANDER_POLYNOMIAL, ///< the Alexander polynomial is not that of the trivial link
  KNOTTED_BY_HOMFLY_POLYNOMIAL     ///< the HOMFLY-PT polynomial is not that of the trivial link
};

/// \ingroup PkgVolumeFillingCurvesKnots
///
/// returns the name in plain English, for example "knotted by determinant".
inline const char* to_string(Knottedness knottedness)
{
  switch(knottedness) {
  case Knottedness::UNKNOWN:
    return "unknown";
  case Knottedness::UNKNOTTED:
    return "unknotted";
  case Knottedness::LINKED_BY_LINKING_NUMBER:
    return "linked by linking number";
  case Knottedness::KNOTTED_BY_DETERMINANT:
    return "knotted by determinant";
  case Knottedness::KNOTTED_BY_ALEXANDER_POLYNOMIAL:
    return "knotted by Alexander polynomial";
  case Knottedness::KNOTTED_BY_HOMFLY_POLYNOMIAL:
    return "knotted by HOMFLY polynomial";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesKnots
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Knottedness knottedness)
{
  return out << to_string(knottedness);
}

namespace internal {

// Returns a proof that the link is trivial or that it is not. A trivial one is only recognized
// without crossings; hence the diagram is simplified first. Cheap invariants come first: different
// residues modulo a prime already prove a knot. A trivial link of several components has the
// determinant and the Alexander polynomial 0.
// \throws Run_stopped in a Watched_scope
inline Knottedness knottedness(const Planar_diagram& diagram)
{
  if(diagram.crossings.empty()) return Knottedness::UNKNOTTED;
  const std::size_t components = number_of_components(diagram);
  // without free loops, which are linked with nothing: up to 10^8 of them
  for(const auto& row : linking_matrix({diagram.crossings, 0}))
    for(const int number : row)
      if(number != 0) return Knottedness::LINKED_BY_LINKING_NUMBER;
  const Alexander_matrix matrix(diagram);
  const Prime_field field;
  const Prime_field::Number trivial = components == 1 ? 1 : 0, minus_one = field.negative(1);
  const auto determinant = matrix.value(minus_one, field);
  if(determinant != trivial && determinant != field.negative(trivial))
    return Knottedness::KNOTTED_BY_DETERMINANT;
  for(const std::uint64_t t : alexander_arguments)
    if(matrix.squared_norm(t, field) != trivial)
      return Knottedness::KNOTTED_BY_ALEXANDER_POLYNOMIAL;
  const auto homfly = homfly_polynomial(diagram);
  if(!homfly) return Knottedness::UNKNOWN;
  auto of_trivial_link = Laurent_polynomial_2::monomial({0, 0});
  for(std::size_t k = 1; k < components; ++k)
    of_trivial_link = of_trivial_link * Homfly_skein::loop();
  return *homfly == of_trivial_link ? Knottedness::UNKNOWN
                                    : Knottedness::KNOTTED_BY_HOMFLY_POLYNOMIAL;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KNOTTEDNESS_H
