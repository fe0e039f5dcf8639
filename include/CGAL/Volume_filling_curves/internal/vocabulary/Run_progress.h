// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_RUN_PROGRESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_RUN_PROGRESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <ostream>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The stages of a run, in their order; no run has them all.
enum class Run_stage
{
  PREPARING,   ///< the input is checked, a domain surveyed
  SEARCHING,   ///< a polygon with few edges is searched
  BRANCHING,   ///< fingers grow all over a domain
  FLOWING,     ///< the curve flows, iteration by iteration
  TIGHTENING,  ///< a closed curve is pulled tight at a constant radius
  SIMPLIFYING, ///< nodes are removed
  MEASURING,   ///< the result is measured
  VERIFYING    ///< a certificate is verified
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "flowing".
inline const char* to_string(Run_stage stage)
{
  switch(stage) {
  case Run_stage::PREPARING:
    return "preparing";
  case Run_stage::SEARCHING:
    return "searching";
  case Run_stage::BRANCHING:
    return "branching";
  case Run_stage::FLOWING:
    return "flowing";
  case Run_stage::TIGHTENING:
    return "tightening";
  case Run_stage::SIMPLIFYING:
    return "simplifying";
  case Run_stage::MEASURING:
    return "measuring";
  case Run_stage::VERIFYING:
    return "verifying";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Run_stage stage)
{
  return out << to_string(stage);
}

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/untangle.h
///
/// How far a run has come. The function that is passed as the parameter `progress` receives it at
/// the beginning of each stage, after each iteration, and every few milliseconds in between, always
/// in the thread that started the run; the run ends if the function returns `false`.
struct Run_progress
{
  Run_stage stage = Run_stage::PREPARING; ///< the stage that the run is in

  /// how much of the stage is done, from 0 to 1; estimated, and 0 where no estimate is known
  double fraction = 0;

  /// iterations of the flow, or sweeps of the search, so far
  std::size_t iterations = 0;

  std::size_t nodes = 0;    ///< of the curve, when it was last measured
  double length = 0;        ///< likewise, in the input's unit
  double gradient_norm = 0; ///< likewise, see `Curve_flow_3::gradient_norm()`
  double seconds = 0;       ///< since the run began

  double thickness = 0; ///< of a filling, in the input's unit; 0 until it is known

  /// the thickness that a filling would have by default, if it takes a larger one in its place; 0
  /// otherwise. See `Filling_parameters`
  double default_thickness = 0;

  double expected_length = 0;     ///< of the filling, in the input's unit; 0 until it is known
  std::size_t expected_nodes = 0; ///< likewise

  /// likewise, of the whole run with one thread, on a recent machine
  double expected_seconds = 0;
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/untangle.h
///
/// Is thrown by functions that return a measure or a verdict, and have no status, if the function
/// that was passed as the named parameter `progress` returns `false`.
class Run_interrupted : public std::runtime_error
{
public:
  /// constructs the exception.
  Run_interrupted() : std::runtime_error("interrupted by the function passed as progress") {}
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_RUN_PROGRESS_H
