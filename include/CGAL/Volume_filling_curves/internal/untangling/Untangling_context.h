// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_CONTEXT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_CONTEXT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Flow_motion.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/knots/Unknot_proofs.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_visitor.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Closing_rays.h>
#include <CGAL/Volume_filling_curves/internal/untangling/flow_monitors.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <cstddef>
#include <limits>
#include <tuple>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Searches so far, and what the next one depends on.
struct Search_state
{
  Random_source seeds{0};
  double patience_factor = 1;
  std::size_t searches = 0, sweeps = 0;
  double seconds = 0; // of all searches; a resumed run counts anew
  bool has_changed_curve = false;
};

// The current flow and what decides its end, between two steps.
struct Flow_run_state
{
  static constexpr std::size_t never = (std::numeric_limits<std::size_t>::max)();

  double thickness = 0;
  Flow_state flow;
  Unknot_proofs proofs;
  Stall_monitor stall_monitor;
  Plateau_monitor plateau_monitor;
  Coarse_phase coarse_phase;
  std::size_t iterations_to_proof = never;
  std::size_t turns_of_rays = 0;
  bool has_stalled = false, are_rays_turning = false;
};

// All that a run of untangle() depends on between two steps, besides the curve and its guard. A run
// that was interrupted continues from a copy.
struct Untangling_state
{
  Ray_sphere sphere;
  double thickness_of_rays = 0;     // given, or measured before the rays were added
  double thickness = 0;             // of the next flow; 0 if it is to be measured
  Curve_flow_statistics statistics; // of the flows that have ended
  Search_state search;
  bool is_flowing = false; // rather than between searches and flows
  Flow_run_state flow_run;

  auto members()
  {
    Flow_run_state& run = flow_run;
    return std::tuple_cat(std::tie(sphere, thickness_of_rays, thickness, statistics, search.seeds,
                                   search.patience_factor, search.searches, search.sweeps,
                                   search.has_changed_curve, is_flowing, run.thickness),
                          run.flow.members(),
                          std::tie(run.proofs.component_proofs, run.proofs.link, run.stall_monitor,
                                   run.plateau_monitor, run.coarse_phase, run.iterations_to_proof,
                                   run.turns_of_rays, run.has_stalled, run.are_rays_turning));
  }

  bool is_valid() const
  {
    return (thickness_of_rays == 0 || is_positive(thickness_of_rays)) &&
           (thickness == 0 || is_positive(thickness)) &&
           (!is_flowing || (is_positive(flow_run.thickness) && flow_run.flow.is_valid()));
  }
};

// Parts of a run that all strategies share.
template <typename Flow>
struct Untangling_context
{
  using Guard = typename Flow::Guard;

  Guard& guard;
  Closing_rays<Guard>& rays;
  const Untangling_parameters& parameters;
  Run_watch& watch; // of the guard as well
  Run_visitor<Flow>& visitor;
  Untangling_state& state;

  // The status of a run that the watch has stopped.
  Untangling_status status_when_stopped() const
  {
    return watch.is_interrupted() ? Untangling_status::INTERRUPTED : Untangling_status::LIMIT;
  }
};

// Result for a curve whose run did not end with a flow. Proofs are about the current curve.
template <typename Network>
Untangling_result result_without_flow(const Network& curve, Untangling_status status)
{
  Untangling_result result;
  Unknot_proofs unknot_proofs;
  unknot_proofs.update(curve);
  unknot_proofs.write(curve, result);
  result.status = unknot_proofs.is_proved() && status != Untangling_status::INTERRUPTED
                      ? Untangling_status::UNKNOTTED
                      : status;
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_CONTEXT_H
