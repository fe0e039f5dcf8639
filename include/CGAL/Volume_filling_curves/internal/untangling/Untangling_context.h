// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_CONTEXT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_CONTEXT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/knots/Unknot_proofs.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Closing_rays.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_state.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Parts of a run that all strategies share.
template <typename Guard, typename Visitor>
struct Untangling_context
{
  Guard& guard;
  Closing_rays<Guard>& rays;
  const Untangling_parameters& parameters;
  Run_watch& watch; // of the guard as well
  Visitor& visitor;
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
