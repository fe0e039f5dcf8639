// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_POLYLINE_CONVENTIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_POLYLINE_CONVENTIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <ostream>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Curve_network_3.h
 *
 * \brief determines which polylines are closed curves.
 *
 * This is the type of the named parameter `closure` of all functions that take polylines but
 * `verify_certificate()`, and of a parameter of `IO::read_curve_network()`, which documents its
 * effect on files. In a closed curve, a last point that repeats the first is not a new node.
 */
enum class Closure
{
  IF_REPEATED, ///< those whose last point repeats the first, as usual in \cgal
  CLOSED,      ///< all of them, whether or not the last point repeats the first
  OPEN         ///< none of them
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Curve_network_3.h
 *
 * \brief determines whether a curve network may have junctions, that is, nodes with more than two
 * edges.
 *
 * This is the type of the named parameter `junctions` of the constructor of `Curve_network_3` from
 * polylines and of `polylines_to_curve_network()`, and of a parameter of
 * `IO::read_curve_network()`. All other functions that take polylines forbid junctions.
 */
enum class Junctions
{
  FORBIDDEN, ///< every component is a closed curve or an arc
  ALLOWED    ///< any graph is allowed; equal end points of polylines are one node
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "if repeated".
inline const char* to_string(Closure closure)
{
  switch(closure) {
  case Closure::IF_REPEATED:
    return "if repeated";
  case Closure::CLOSED:
    return "closed";
  case Closure::OPEN:
    return "open";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Closure closure)
{
  return out << to_string(closure);
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "forbidden".
inline const char* to_string(Junctions junctions)
{
  switch(junctions) {
  case Junctions::FORBIDDEN:
    return "forbidden";
  case Junctions::ALLOWED:
    return "allowed";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Junctions junctions)
{
  return out << to_string(junctions);
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_POLYLINE_CONVENTIONS_H
