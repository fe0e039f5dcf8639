// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RESULT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RESULT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// How a filling ended.
enum class Filling_status
{
  CONVERGED,          ///< the length has settled, every empty region was driven at, and at most 1 %
                      ///< of the volume is farther than 2 r from the curve
  PARTIAL,            ///< likewise, but more of the volume is; `Filling_result::reason` says why
  LENGTH_NOT_REACHED, ///< the length has settled more than 2 % off the one asked for
  LIMIT,              ///< the limit of iterations or of time was reached
  STALLED,            ///< several steps running could not be certified, however short
  INTERRUPTED         ///< the visitor asked to stop
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "converged".
inline const char* to_string(Filling_status status)
{
  switch(status) {
  case Filling_status::CONVERGED:
    return "converged";
  case Filling_status::PARTIAL:
    return "partial";
  case Filling_status::LENGTH_NOT_REACHED:
    return "length not reached";
  case Filling_status::LIMIT:
    return "limit";
  case Filling_status::STALLED:
    return "stalled";
  case Filling_status::INTERRUPTED:
    return "interrupted";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Filling_status status)
{
  return out << to_string(status);
}

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/fill.h
///
/// What `fill()` returns. Whatever the status, the curve lies strictly inside the domain and is
/// ambient isotopic to the one it started as.
///
/// \tparam Point_3 the type of points
template <typename Point_3>
struct Filling_result
{
  Filling_status status = Filling_status::LIMIT; ///< how the run ended
  double thickness = 0; ///< r, in the input's unit; the mean of the nodes' if it varies

  /// the thickness by default, if the run took a larger one, to have about 200,000 nodes; else 0
  double default_thickness = 0;

  double medial_radius = 0; ///< the mean medial radius, capped by the boundary and at 2 r
  double gradient_norm = 0; ///< at the end, see `Curve_flow_3::gradient_norm()`
  /// the share of the volume that the curve is to fill but that is farther than 2 r from it; with
  /// `Wall::KEEP_CLEAR` what is within 2 r of the boundary is not to be filled and does not count.
  /// Not a number if there was no time to measure it
  double unfilled_fraction = 0;
  /// the share of the whole volume that is farther than 2 r from the curve, the same unless
  /// `Wall::KEEP_CLEAR` was asked for
  double uncovered_fraction = 0;
  Coverage coverage; ///< the distances of uniform samples inside to the curve, over r
  /// where the curve did not get to
  std::vector<Empty_region_3<Point_3>> empty_regions;
  /// whether they were searched for, which takes time; if the time was up they are unknown
  bool are_empty_regions_known = false;

  /// the number of connected parts of the inside that are wide enough for a curve, that is, hold a
  /// ball with an eighth of the radius r, or of that of the widest ball inside
  std::size_t parts = 0;

  /// the number of those in which no curve was started, as can be if curves are given
  std::size_t unreachable_parts = 0;

  /// how much of the domain is too thin for the thickness that the run began with
  Thickness_fit thickness_fit;

  /// why more than 1 % of the volume is farther than 2 r from the curve, in plain English, if the
  /// status is `PARTIAL` or `STALLED`; else empty
  std::string reason;

  /// the circles that the run has started from if no curve was given: polylines whose last point
  /// repeats the first. The run's certificate leads from them to the result: both can be passed to
  /// `verify_certificate()`
  std::vector<std::vector<Point_3>> start;

  Curve_flow_statistics statistics; ///< the work
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RESULT_H
