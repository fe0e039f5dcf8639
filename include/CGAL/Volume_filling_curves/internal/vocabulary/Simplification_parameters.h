// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_SIMPLIFICATION_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_SIMPLIFICATION_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <functional>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {

class Isotopy_certificate;

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/simplify_curves.h
 *
 * \brief The parameters of `simplify_curves()`.
 *
 * Each member can be set by the named parameter of the same name.
 */
struct Simplification_parameters
{
  /// The largest Fréchet distance between an edge of the result and the section of the input that
  /// it replaces, in the input's unit. Infinite by default.
  double max_distance = std::numeric_limits<double>::infinity();

  /// The clearance, in the input's unit, see `Isotopy_guard_3::set_clearance()`: a removal brings
  /// edges without a common node nearer than that only if it leaves at least half of their
  /// distance. 0 (default) for none.
  double clearance = 0;

  /// Receives the record of the run, like `Curve_run_parameters::certificate`.
  Isotopy_certificate* certificate = nullptr;

  /// Is called like `Curve_run_parameters::progress`. If it returns `false`, no further nodes are
  /// removed.
  std::function<bool(const Run_progress&)> progress;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_SIMPLIFICATION_PARAMETERS_H
