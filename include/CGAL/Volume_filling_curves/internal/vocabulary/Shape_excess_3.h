// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_SHAPE_EXCESS_3_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_SHAPE_EXCESS_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/fill.h
///
/// The point where a curve exceeds a limit of its shape most.
///
/// \tparam Point_3 the type of points
template <typename Point_3 = Curve_flow_traits_3<>::Point_3>
struct Shape_excess_3
{
  Point_3 point;       ///< on the curve
  double value = 0;    ///< the bend radius or the distance of strands there, in the input's unit
  double limit = 0;    ///< the one that is required there
  bool is_bend = true; ///< whether it is a bend, or else a distance of strands
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_SHAPE_EXCESS_3_H
