// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTITY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTITY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Knottedness.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesKnots
/// \headerfile CGAL/Volume_filling_curves/identify.h
///
/// Whether a knot or link is isotopic to its mirror image, for any orientation of its components.
enum class Knot_chirality
{
  UNKNOWN,    ///< no proof, or no name
  CHIRAL,     ///< it is not; the name distinguishes the two
  AMPHICHIRAL ///< it is
};

/// \ingroup PkgVolumeFillingCurvesKnots
///
/// returns the name in plain English, for example "chiral".
inline const char* to_string(Knot_chirality chirality)
{
  switch(chirality) {
  case Knot_chirality::UNKNOWN:
    return "unknown";
  case Knot_chirality::CHIRAL:
    return "chiral";
  case Knot_chirality::AMPHICHIRAL:
    return "amphichiral";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesKnots
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Knot_chirality chirality)
{
  return out << to_string(chirality);
}

/// \ingroup PkgVolumeFillingCurvesKnots
/// \headerfile CGAL/Volume_filling_curves/identify.h
///
/// The result of `identify()`: name, proofs and invariants of a knot or link.
struct Link_identity
{
  /// The knot in Rolfsen's table, such as "7_5"; with an asterisk its mirror image, such as "7_5*";
  /// a connected sum of such knots, such as "3_1#3_1*"; "0_1" for the unknot, and
  /// "unlink of 2 components". The knot without asterisk is the closure of its braid word in
  /// KnotInfo, read such that letter 1 is a positive crossing: "3_1" is the right-handed trefoil.
  /// A prime link of up to 6 crossings likewise, such as "6^3_2" for the Borromean rings, for any
  /// orientation of its components; without asterisk it is the closure of a braid word in
  /// `data/prime_links.txt`. Empty if no such knot or link has the same polynomials, or they exceed
  /// the limits.
  std::string name;

  /// Whether the name is a theorem: no piece of the diagram has more than 10 crossings, or 6 for
  /// several components. Otherwise it has the polynomials of the knot or link with that name.
  bool is_proved = false;

  /// Whether the knot or link is proved to be trivial or not, whatever its name.
  Knottedness knottedness = Knottedness::UNKNOWN;

  /// The chirality of a knot or link with a name. Without a proof of the name it is never
  /// amphichiral, and unknown for links: polynomials only prove that a knot is chiral.
  Knot_chirality chirality = Knot_chirality::UNKNOWN;

  std::size_t number_of_components = 0; ///< of the link

  /// A diagram with few crossings, from which everything else follows.
  Planar_diagram diagram;

  /// The linking numbers of the components of the diagram: of those with crossings, in the order of
  /// their arcs, and then of those without.
  std::vector<std::vector<int>> linking_matrix;

  /// The HOMFLY-PT polynomial with \f$v^{-1} P_+ - v P_- = z P_0\f$, as "2 v^2 + v^2 z^2 - v^4";
  /// empty if it exceeds the limits.
  std::string homfly_polynomial;

  /// The Jones polynomial, as "t + t^3 - t^4", of links in the square root s of t; empty if it
  /// exceeds the limits.
  std::string jones_polynomial;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTITY_H
