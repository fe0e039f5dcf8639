// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_SIMPLIFICATION_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_SIMPLIFICATION_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <limits>

namespace CGAL {
namespace Volume_filling_curves {

class Isotopy_certificate;

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The parameters of `simplify_curves()`.
 *
 * Each member can be set by the named parameter of the same name.
 */
struct Simplification_parameters
{
  /// The largest Fréchet distance between an edge of the result and the part of the input that it
  /// stands for, in the input's unit. Infinite by default.
  double max_distance = std::numeric_limits<double>::infinity();

  /// The distance that edges without a common node keep, see `Isotopy_guard_3::set_clearance()`, in
  /// the input's unit. 0 (default) for none.
  double clearance = 0;

  /// Receives the record of the run, as `Curve_run_parameters::certificate`.
  Isotopy_certificate* certificate = nullptr;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_SIMPLIFICATION_PARAMETERS_H
