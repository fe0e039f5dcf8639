// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_PORT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_PORT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>

#include <array>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The struct `Port` is a point at the boundary of a domain where a filling enters it.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3 = Curve_flow_traits_3<>::Point_3>
struct Port
{
  /// The point, on the boundary or within r of it.
  Point_3 point;

  /// The direction, of any length, in which the curve enters, hence crosses the boundary from
  /// outside. Zero (default) stands for the inward normal.
  std::array<double, 3> direction = {0, 0, 0};
};

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

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_PORT_H
