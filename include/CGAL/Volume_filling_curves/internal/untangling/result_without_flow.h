// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RESULT_WITHOUT_FLOW_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RESULT_WITHOUT_FLOW_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/knots/Unknottedness.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The result for a curve that did not flow, or not at last. Proofs are about the curve as it
// stands.
template <typename Network>
Untangling_result result_without_flow(const Network& curve, Untangling_status status)
{
  Untangling_result result;
  Unknottedness<Network> unknottedness;
  unknottedness.update(curve);
  unknottedness.write(curve, result);
  result.status = unknottedness.is_proved() && status != Untangling_status::INTERRUPTED
                      ? Untangling_status::UNKNOTTED
                      : status;
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RESULT_WITHOUT_FLOW_H
