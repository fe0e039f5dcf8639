// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_RUN_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_RUN_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {

class Isotopy_certificate;
struct Run_checkpoint;
class Run_state;

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/untangle.h
 *
 * \brief The common parameters of `untangle()` and `fill()`: those of the flow, of the end of a
 * run, and of its records.
 *
 * Each member can be set by the named parameter of the same name.
 */
struct Curve_run_parameters : Curve_flow_parameters
{
  /// The largest number of iterations of the flow; with `Untangling_strategy::SEARCH`, of sweeps,
  /// see `Search_progress`.
  std::size_t number_of_iterations = 5000;

  /// The time limit, in seconds. A step that exceeds it is abandoned, unless there is a
  /// `checkpoint`. Infinite by default.
  double time_limit = std::numeric_limits<double>::infinity();

  /// The seed of all random numbers, on which the result depends: in `untangle()` those of the
  /// searches, in `fill()` those of the tree of fingers, and of the samples that reveal parts,
  /// widest points and empty regions.
  std::size_t random_seed = 0;

  /// Receives the record of the whole run for `verify_certificate()`; if null (default), nothing is
  /// recorded. As a named parameter, pass `std::ref()` of the certificate. The record takes some 26
  /// bytes per node and iteration.
  Isotopy_certificate* certificate = nullptr;

  /// Is called with a `Run_progress` every few milliseconds from the start of the run to its end,
  /// in the thread that started the run. If it returns `false`, the run ends with the status
  /// `INTERRUPTED` and the current curve, which is valid. None by default.
  std::function<bool(const Run_progress&)> progress;

  /// Is called before each iteration, and where the run ends before its goal, with a
  /// `Run_checkpoint`, which provides the state of the run. None by default.
  std::function<void(const Run_checkpoint&)> checkpoint;

  /// The state to resume from, with the same curves, domain and parameters, except for
  /// `number_of_iterations` and `time_limit`. If it is null (default) or empty, the run starts at
  /// the beginning. As a named parameter, pass `std::cref()` of the state. Iterations count from
  /// the beginning of the run, the time from its resumption. A state that is damaged or belongs to
  /// a different run throws `Run_state_error`, whose message names the difference.
  const Run_state* resume_from = nullptr;

  /// A name of the calling program's build, such as its commit, or empty (default). States store
  /// it, and a run does not resume from the state of a different build, since two builds of the
  /// same version may differ in the last bits.
  std::string build_name;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_RUN_PARAMETERS_H
