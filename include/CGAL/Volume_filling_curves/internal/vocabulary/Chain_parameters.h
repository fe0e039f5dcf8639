// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CHAIN_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CHAIN_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 * \headerfile CGAL/Volume_filling_curves/identify.h
 *
 * \brief The parameters of `identify_chain()`.
 *
 * Each member can be set by the named parameter of the same name.
 */
struct Chain_parameters
{
  /// The number of directions in which the ends of the chain are extended. 100 by default.
  std::size_t closures = 100;

  /// The seed of the rotation that is applied to the lattice of directions. 0 by default.
  std::size_t random_seed = 0;

  /// Whether to look for the core of the knot. `false` by default.
  bool find_core = false;

  /// The number of edges between the nodes at which sections of the fingerprint begin and end. 0
  /// (default) for no fingerprint.
  std::size_t stride = 0;

  /// Is called with a `Run_progress` every few milliseconds, like
  /// `Curve_run_parameters::progress`. If it returns `false`, `Run_interrupted` is thrown.
  std::function<bool(const Run_progress&)> progress;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CHAIN_PARAMETERS_H
