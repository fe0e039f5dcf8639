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
/// The stages of a run, in order; no run has all of them.
enum class Run_stage
{
  PREPARING,   ///< the input is checked, and a domain surveyed
  SEARCHING,   ///< a random search looks for a polygon with few edges
  BRANCHING,   ///< fingers grow through a domain
  FLOWING,     ///< the curve flows, iteration by iteration
  TIGHTENING,  ///< a closed curve is tightened at a constant radius
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
/// The progress of a run. The function passed as the parameter `progress` receives it at the
/// beginning of each stage, after each iteration, and every few milliseconds in between, always in
/// the thread that started the run. If the function returns `false`, the run ends.
struct Run_progress
{
  Run_stage stage = Run_stage::PREPARING; ///< the current stage

  /// the completed fraction of the stage, from 0 to 1; an estimate, or 0 if there is none
  double fraction = 0;

  /// iterations of the flow, or sweeps of the search, so far
  std::size_t iterations = 0;

  std::size_t nodes = 0;    ///< nodes of the curve when last measured
  double length = 0;        ///< length of the curve when last measured, in the input's unit
  double gradient_norm = 0; ///< `Curve_flow_3::gradient_norm()` when last measured
  double seconds = 0;       ///< seconds since the start of the run

  double thickness = 0; ///< thickness of a filling, in the input's unit; 0 until it is known

  /// the default thickness of a filling that uses a larger one instead; 0 otherwise. See
  /// `Filling_parameters`
  double default_thickness = 0;

  double expected_length = 0;     ///< expected length of the filling, in the input's unit; 0 until
                                  ///< it is known
  std::size_t expected_nodes = 0; ///< expected nodes of the filling; 0 until they are known

  /// expected time of the whole run with one thread, on a recent machine; 0 until it is known
  double expected_seconds = 0;
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/untangle.h
///
/// The progress of a random search: that of its best chain so far, see
/// `Untangling_parameters::number_of_chains`.
struct Search_progress
{
  std::size_t sweeps = 0; ///< the number of sweeps, which are a hundred attempted moves per edge
  std::size_t moves = 0;  ///< the number of attempted moves
  std::size_t edges = 0;  ///< the fewest edges found so far
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/untangle.h
///
/// The exception of functions that return no status, such as measures, if the function passed as
/// the named parameter `progress` returns `false`.
class Run_interrupted : public std::runtime_error
{
public:
  /// constructs the exception.
  Run_interrupted() : std::runtime_error("interrupted by the function passed as progress") {}
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_RUN_PROGRESS_H
