// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FLOW_NAMED_PARAMETERS_H
#define VFC_FLOW_NAMED_PARAMETERS_H

#include "shared_options.h"

#include <CGAL/Volume_filling_curves/parameters.h>

namespace vfc {

// What the functions of the package that let curves flow take alike, from the options.
inline auto flow_named_parameters(const Flow_options& flow,
                                  const CGAL::Volume_filling_curves::internal::Stop_rules& stop)
{
  const CGAL::Volume_filling_curves::Curve_flow_parameters& p = flow.parameters;
  return CGAL::Volume_filling_curves::parameters::number_of_directions(p.number_of_directions)
      .max_radius(p.max_radius)
      .spacing(p.spacing)
      .screening(p.screening)
      .coupling(p.coupling)
      .preconditioner(flow.preconditioner())
      .time_step(p.time_step)
      .number_of_iterations(stop.max_iterations)
      .time_limit(stop.time_limit);
}

} // namespace vfc

#endif // VFC_FLOW_NAMED_PARAMETERS_H
