// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_SPLINE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_SPLINE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/arc_spline.h
///
/// An arc or a segment of an arc spline.
///
/// \tparam Point_3 the type of points
template <typename Point_3>
struct Arc_spline_piece
{
  Point_3 start;  ///< the first point
  Point_3 corner; ///< the intersection of an arc's end tangents; a segment's midpoint
  Point_3 middle; ///< the point halfway
  Point_3 end;    ///< the last point

  /// the radius, in the input's unit; infinity for a segment
  double radius = std::numeric_limits<double>::infinity();

  double length = 0; ///< the length, in the input's unit

  /// the node at the corner that an arc replaces; for a segment, the last node before it
  std::size_t node = 0;

  /// returns whether the piece is an arc, not a segment.
  bool is_arc() const { return std::isfinite(radius); }
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/arc_spline.h
///
/// Consecutive pieces of an arc spline: a component of the curve, or a part of it between two
/// junctions or ends.
///
/// \tparam Point_3 the type of points
template <typename Point_3>
struct Arc_spline_path
{
  std::size_t component = 0; ///< the component of the curve
  bool is_closed = false;    ///< whether the last piece continues smoothly into the first

  /// the pieces; each one starts where the one before it ends
  std::vector<Arc_spline_piece<Point_3>> pieces;
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/arc_spline.h
///
/// The reason why an arc cannot be certified.
enum class Arc_obstacle
{
  STRAND,   ///< its triangle meets another arc's triangle, or a segment
  BOUNDARY, ///< its triangle is not strictly inside the domain
  ROUNDING  ///< after rounding, its ends coincide with nodes, or reaching them crosses a strand
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/arc_spline.h
///
/// returns the reason as a word.
inline const char* to_string(Arc_obstacle obstacle)
{
  switch(obstacle) {
  case Arc_obstacle::STRAND:
    return "strand";
  case Arc_obstacle::BOUNDARY:
    return "boundary";
  default:
    return "rounding";
  }
}

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/arc_spline.h
///
/// An arc that cannot be certified.
struct Arc_conflict
{
  std::size_t node = 0;                         ///< the node at the corner
  Arc_obstacle obstacle = Arc_obstacle::STRAND; ///< the reason
  std::size_t other = 0; ///< the node of the strand that is met; `node` if there is none
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/arc_spline.h
///
/// The result of `arc_spline()`. Lengths are in the input's unit.
///
/// \tparam Point_3 the type of points
template <typename Point_3>
struct Arc_spline
{
  /// the arcs and segments, in the order of the curve
  std::vector<Arc_spline_path<Point_3>> paths;

  /// whether the spline is certified to be ambient isotopic to the curve, inside the domain
  bool is_certified = false;

  /// the arcs that cannot be certified, in the order of their nodes, with one reason each
  std::vector<Arc_conflict> conflicts;

  std::size_t number_of_arcs = 0;     ///< the number of arcs
  std::size_t number_of_segments = 0; ///< the number of segments

  /// the least radius of an arc, which is `min_bend_radius()` of a curve without junctions;
  /// infinity if there are no arcs
  double min_radius = std::numeric_limits<double>::infinity();

  double max_distance = 0; ///< the largest distance of a point of the curve to the spline
  double length = 0;       ///< the total length of all pieces
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_SPLINE_H
