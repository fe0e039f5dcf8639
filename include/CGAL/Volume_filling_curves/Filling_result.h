// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_FILLING_RESULT_H
#define CGAL_VOLUME_FILLING_CURVES_FILLING_RESULT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/coverage.h>

#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// How a filling ended.
enum class Filling_status
{
  CONVERGED,  ///< the length has settled, and every empty region was driven at
  LIMIT,      ///< the limit of iterations or of time was reached
  STALLED,    ///< several steps running could not be certified, however short
  INTERRUPTED ///< the visitor asked to stop
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// What `fill()` returns. Whatever the status, the curve lies strictly inside the domain and is
/// ambient isotopic to the one it started as.
///
/// \tparam Point_3 the type of points
template <typename Point_3>
struct Filling_result
{
  Filling_status status = Filling_status::LIMIT; ///< how the run ended
  double thickness = 0;     ///< r, in the input's unit; the mean of the nodes' if it varies
  double medial_radius = 0; ///< the mean medial radius, capped by the boundary and at 2 r
  double gradient_norm = 0; ///< at the end, see `Curve_flow_3::gradient_norm()`
  std::vector<Empty_region_3<Point_3>> empty_regions; ///< where the curve did not get to
  Curve_flow_statistics statistics;                   ///< the work
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_FILLING_RESULT_H
