// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_CURVE_RUN_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_CURVE_RUN_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {

class Isotopy_certificate;

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The parameters that `untangle()` and `fill()` have in common: those of the flow, when a
 * run ends, and what it records.
 *
 * Each member can be set by the named parameter of the same name.
 */
struct Curve_run_parameters : Curve_flow_parameters
{
  /// The largest number of iterations of the flow; of the sweeps of `Search_progress` with
  /// `Untangling_strategy::SEARCH`.
  std::size_t number_of_iterations = 5000;

  /// The longest time to run, in seconds, checked between iterations. Infinite by default.
  double time_limit = std::numeric_limits<double>::infinity();

  /// The seed of all that is random, on which the result depends: the searches of `untangle()`, and
  /// the samples with which `fill()` finds parts, widest places and empty regions.
  std::size_t random_seed = 0;

  /// Receives the record of the whole run, which `verify_certificate()` verifies; nothing is
  /// recorded if it is null (default). As a named parameter, pass `std::ref()` of the certificate.
  /// The record takes some 26 bytes per node and iteration.
  Isotopy_certificate* certificate = nullptr;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_CURVE_RUN_PARAMETERS_H
