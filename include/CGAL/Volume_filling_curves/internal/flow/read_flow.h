// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_READ_FLOW_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_READ_FLOW_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Whether parameters are those of a flow of a run with other ones. A run takes coarser ones for
// some of its stages, and finds the thickness; all else stays.
inline bool are_of_run(const Curve_flow_parameters& p, const Curve_flow_parameters& of_run)
{
  try {
    check_parameters(p);
  } catch(const std::invalid_argument&) {
    return false;
  }
  return p.thickness > 0 && p.number_of_directions <= of_run.number_of_directions &&
         p.max_radius <= of_run.max_radius && p.spacing >= of_run.spacing &&
         p.medial_weight == of_run.medial_weight && p.coupling == of_run.coupling &&
         p.preconditioner == of_run.preconditioner && p.wall == of_run.wall &&
         p.time_step == of_run.time_step;
}

// Reads a flow that has the parameters of its run. Throws Run_state_error if it reads others:
// a forged state that claims 2^60 directions would take all memory.
template <typename Flow>
void read_flow(State_reader& reader, Flow& flow)
{
  const Curve_flow_parameters of_run = flow.parameters();
  reader(flow);
  reader.require(are_of_run(flow.parameters(), of_run));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_READ_FLOW_H
