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

  /// Is called with a `Run_progress` from the first moment of the run to its end, every few
  /// milliseconds, in the thread that started the run. If it returns `false`, the run ends with the
  /// status `INTERRUPTED` and the curve as it is by then, which is valid. None by default.
  std::function<bool(const Run_progress&)> progress;

  /// Is called before each iteration, and where the run ends before its goal, with a
  /// `Run_checkpoint`, from which the state of the run can be taken. None by default.
  std::function<void(const Run_checkpoint&)> checkpoint;

  /// The state that the run goes on from, with the same curves, the same domain and the same
  /// parameters but for `number_of_iterations` and `time_limit`; it starts at the beginning if this
  /// is null (default) or the state is empty. As a named parameter, pass `std::cref()` of it.
  /// Iterations are counted from the beginning, the time from where it resumes.
  const Run_state* resume_from = nullptr;

  /// A name of the program that runs, such as the commit that it was built from, or empty
  /// (default). States keep it, and a run does not resume from that of another one: two builds of
  /// one version of this package may differ in the last bits.
  std::string build_name;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_RUN_PARAMETERS_H
