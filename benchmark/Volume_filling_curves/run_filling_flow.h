// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_RUN_FILLING_FLOW_H
#define VFC_BENCHMARK_RUN_FILLING_FLOW_H

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_state.h>
#include <CGAL/Volume_filling_curves/internal/filling/Widest_ball.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>

#include <CGAL/Real_timer.h>

#include "Filling_options.h"

namespace vfc_benchmark {

using Traits = vfc::Curve_flow_traits_3<>;
using Curve = vfc::Curve_network_3<Traits>;
using Point = Traits::Point_3;
using Filling = vfc::Filling_result<Point>;

// Fills a domain as a user does.
template <typename Domain>
Filling run_fill(Curve& curve, const Domain& domain, const Filling_options& options)
{
  return vfc::fill(curve, domain, options.parameters);
}

// How the flow alone goes: from a circle in the widest place, with the same parameters throughout,
// as in the paper. It ends when the curve is as long as asked for or, if nothing is asked for, when
// the length changes by less than 0.1 % over 20 iterations.
template <typename Flow>
vfc::Filling_status run_steps(Flow& flow, const Filling_options& options)
{
  constexpr int max_steps_without_motion = 5;
  constexpr std::size_t window = 20;
  constexpr double change_of_length = 1e-3;
  CGAL::Real_timer timer;
  timer.start();
  vfc::internal::Length_window lengths;
  int steps_without_motion = 0;
  for(std::size_t k = 0;
      k < options.parameters.number_of_iterations && timer.time() < options.parameters.time_limit;
      ++k) {
    steps_without_motion = flow.step() ? 0 : steps_without_motion + 1;
    if(steps_without_motion == max_steps_without_motion) return vfc::Filling_status::STALLED;
    lengths.add(flow.length());
    if(options.until_length > 0 ? flow.length() >= options.until_length
                                : lengths.has_settled(window, change_of_length))
      return vfc::Filling_status::CONVERGED;
  }
  return vfc::Filling_status::LIMIT;
}

template <typename Domain>
Filling run_flow_alone(Curve& curve, const Domain& domain, const Filling_options& options)
{
  const Traits traits;
  const vfc::Domain_samples_3<Traits, Domain> samples(domain, 20000,
                                                      options.parameters.random_seed);
  const vfc::internal::Boundary_distances<Domain> distances(domain, samples.points());
  const vfc::internal::Widest_ball<Domain, Traits> widest(
      domain, samples.points(), distances.up_to_limit(), distances.limit(), traits);
  curve = Curve(widest.circle(widest.radius()));
  vfc::Isotopy_guard_3 guard(curve, domain);
  vfc::Curve_flow_3 flow(guard, options.parameters);
  Filling result;
  result.status = run_steps(flow, options);
  result.thickness = flow.thickness();
  result.medial_radius = flow.mean_medial_radius();
  result.gradient_norm = flow.gradient_norm();
  result.statistics = flow.statistics();
  result.empty_regions =
      vfc::empty_regions(curve, samples, vfc::sample_distances(curve, samples), result.thickness);
  return result;
}

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_RUN_FILLING_FLOW_H
