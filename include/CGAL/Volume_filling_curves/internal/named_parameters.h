// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/Stop_rules.h>
#include <CGAL/Volume_filling_curves/internal/Strategy_parameters.h>
#include <CGAL/Volume_filling_curves/parameters.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The named parameters of the public functions, collected into the plain structs that the
// algorithms take.

template <typename NamedParameters, typename Tag, typename Value>
Value parameter_or(const NamedParameters& np, Tag tag, const Value& default_value)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return static_cast<Value>(choose_parameter(get_parameter(np, tag), default_value));
}

template <typename NamedParameters>
Curve_flow_parameters get_flow_parameters_but_thickness(const NamedParameters& np,
                                                        const Curve_flow_parameters& d)
{
  namespace names = Volume_filling_curves::internal_np;
  Curve_flow_parameters p = d;
  p.number_of_directions = parameter_or(np, names::number_of_directions, d.number_of_directions);
  p.max_radius = parameter_or(np, names::max_radius, d.max_radius);
  p.spacing = parameter_or(np, names::spacing, d.spacing);
  p.screening = parameter_or(np, names::screening, d.screening);
  p.coupling = parameter_or(np, names::coupling, d.coupling);
  p.preconditioner = parameter_or(np, names::preconditioner, d.preconditioner);
  p.wall = parameter_or(np, names::wall, d.wall);
  p.time_step = parameter_or(np, names::time_step, d.time_step);
  return p;
}

template <typename NamedParameters>
Curve_flow_parameters get_flow_parameters(const NamedParameters& np)
{
  Curve_flow_parameters p = get_flow_parameters_but_thickness(np, Curve_flow_parameters());
  p.thickness = parameter_or(np, Volume_filling_curves::internal_np::thickness, p.thickness);
  return p;
}

template <typename NamedParameters>
Stop_rules get_stop_rules(const NamedParameters& np)
{
  namespace names = Volume_filling_curves::internal_np;
  Stop_rules rules;
  rules.tolerance = parameter_or(np, names::tolerance, rules.tolerance);
  rules.max_iterations =
      parameter_or(np, CGAL::internal_np::number_of_iterations, rules.max_iterations);
  rules.time_limit = parameter_or(np, names::time_limit, rules.time_limit);
  rules.stop_at_proof = parameter_or(np, names::stop_at_proof, rules.stop_at_proof);
  return rules;
}

template <typename NamedParameters>
Strategy_parameters get_strategy_parameters(const NamedParameters& np)
{
  namespace names = Volume_filling_curves::internal_np;
  Strategy_parameters p;
  p.strategy = parameter_or(np, names::strategy, p.strategy);
  p.number_of_chains = parameter_or(np, names::number_of_chains, p.number_of_chains);
  p.seed = parameter_or(np, CGAL::internal_np::random_seed, p.seed);
  return p;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_NAMED_PARAMETERS_H
