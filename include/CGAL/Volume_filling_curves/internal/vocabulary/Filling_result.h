// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FILLING_RESULT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FILLING_RESULT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Coverage.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <array>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The outcome of a filling.
enum class Filling_status
{
  CONVERGED,          ///< the curve has settled within its limits, and at most 1 % of the volume is
                      ///< farther than 2 r from it
  PARTIAL,            ///< like `CONVERGED`, but more of the volume is farther, or another strand is
                      ///< nearer than r along more than 5 % of the length;
                      ///< `Filling_result::reason` states the cause
  LENGTH_NOT_REACHED, ///< the curve has settled with a length more than 2 % off the required one
  CONSTRAINT_NOT_REACHED, ///< the curve has settled, but bends more tightly or has closer strands
                          ///< than required; `Filling_result::shape_excesses` states where
  LIMIT,                  ///< the limit of iterations or of time was reached
  STALLED,                ///< several steps in a row could not be certified, however short
  INTERRUPTED             ///< the visitor or `progress` ended the run
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
  case Filling_status::CONSTRAINT_NOT_REACHED:
    return "constraint not reached";
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

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The struct `Port_neck` is the straight part of a curve behind a port.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3>
struct Port_neck
{
  Point_3 wall;                                ///< the intersection of its line with the boundary
  Point_3 end;                                 ///< the end of the curve, r/64 from there
  std::array<double, 3> direction = {0, 0, 0}; ///< of the neck, a unit vector that leads inside
  double length = 0; ///< from the boundary to where the curve may bend, in the input's unit
  /// whether no strand meets the segment from the boundary to the end of the curve, which is exact
  bool is_free = false;
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/fill.h
///
/// The result of `fill()`. Whatever the status, the curve is ambient isotopic to the start, and
/// lies strictly inside the domain unless the run was stopped before it had checked the given
/// curves. Lengths are in the input's unit. In a planar domain, shares of the volume are shares of
/// the area.
///
/// \tparam Point_3 the type of points
template <typename Point_3>
struct Filling_result
{
  Filling_status status = Filling_status::LIMIT; ///< how the run ended
  double thickness = 0; ///< r, in the input's unit; if it varies, the mean over the nodes

  /// the default thickness, if the run used a larger one to limit the curve to about 200,000 nodes;
  /// otherwise 0
  double default_thickness = 0;

  /// the mean medial radius, capped at the boundary and at 2 r; NaN if the run was stopped before
  /// the flow or within a step
  double medial_radius = 0;
  /// the final `Curve_flow_3::gradient_norm()`; NaN if the run was stopped before it was known
  double gradient_norm = 0;
  /// the unfilled share of the volume, which is farther than 2 r from the curve; with
  /// `Wall::KEEP_CLEAR`, the volume within 2 r of the boundary, or within half the radius of the
  /// widest ball inside if that is less, does not count, nor does the volume nearer to it than a
  /// `wall_distance`. NaN if there was no time to measure it
  double unfilled_fraction = 0;
  /// the share of the whole volume that is farther than 2 r from the curve; differs from
  /// `unfilled_fraction` only with `Wall::KEEP_CLEAR` or a `wall_distance`
  double uncovered_fraction = 0;
  Coverage coverage; ///< statistics of the distances from samples to the curve, over r
  /// the regions that the curve did not reach
  std::vector<Empty_region_3<Point_3>> empty_regions;
  /// whether there was time to search for empty regions
  bool are_empty_regions_known = false;

  /// the least bend radius of the curve, see `tightest_bend()`; NaN, as the following, if there was
  /// no time to measure it
  double min_bend_radius = std::numeric_limits<double>::quiet_NaN();
  std::size_t tightest_node = static_cast<std::size_t>(-1); ///< the node of the curve that has it

  /// the least distance between two strands, see `min_strand_distance()`
  double min_strand_distance = std::numeric_limits<double>::quiet_NaN();
  /// the point of each that is nearest to the other
  std::array<Point_3, 2> closest_points = {Point_3(0, 0, 0), Point_3(0, 0, 0)};

  /// the least distance of the curve to the boundary, see `min_wall_distance()`; with ports at most
  /// r/64, the distance at which their necks end
  double min_wall_distance = std::numeric_limits<double>::quiet_NaN();
  Point_3 point_nearest_to_wall = Point_3(0, 0, 0); ///< the point of the curve that has it

  /// the share of the length along which another strand is nearer than r, see `crowded_fraction()`
  double crowded_fraction = std::numeric_limits<double>::quiet_NaN();

  /// the number of connected parts of the inside that are wide enough for a curve, see `fill()`
  std::size_t parts = 0;

  /// the number of these parts without a curve, which may occur if curves are given
  std::size_t unreachable_parts = 0;

  /// the fit of the initial thickness to the domain
  Thickness_fit thickness_fit;

  /// the tightest bend and the closest strands in comparison with what is required, as far as they
  /// exceed that
  std::vector<Shape_excess_3<Point_3>> shape_excesses;

  /// the reason, in English. With the status `LENGTH_NOT_REACHED` it states the length. With
  /// `PARTIAL`, `CONSTRAINT_NOT_REACHED` or `STALLED` it states which limits of the shape are
  /// exceeded, and why more than 1 % of the volume is farther than 2 r from the curve, or another
  /// strand nearer than r along more than 5 % of the length; empty if a stalled curve has none of
  /// these faults. Empty with any other status
  std::string reason;

  /// the straight parts of the curve at the ports, in their order
  std::vector<Port_neck<Point_3>> necks;

  /// the circles that the run started from if no curve was given, as polylines whose last point
  /// repeats the first; with ports, the arcs. They are the start curve of the run's certificate,
  /// see `verify_certificate()`
  std::vector<std::vector<Point_3>> start;

  Curve_flow_statistics statistics; ///< the work
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FILLING_RESULT_H
