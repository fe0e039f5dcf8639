// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_TASK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_TASK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/Stop_rules.h>
#include <CGAL/Volume_filling_curves/internal/named_parameters.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// What a filling is asked for.
template <typename Point_3>
struct Filling_task
{
  Curve_flow_parameters parameters;                // with the thickness, or where to start from
  std::function<double(const Point_3&)> thickness; // if it varies
  double length = 0;                               // if asked for instead of a thickness
  double coarsest_thickness = 0;                   // with which the curve starts to grow
  Stop_rules rules;
};

// The length of a curve that fills a volume V with thickness r is this times V / r^2: 0.259 to 0.269
// on nine domains of run_filling (2026-11-21).
constexpr double filling_density = 0.26;

// The parameters of a flow that fills, but for the thickness.
inline Curve_flow_parameters filling_defaults()
{
  Curve_flow_parameters p;
  p.medial_weight = 3.15 * 3.15; // the curve settles with a mean medial radius of r
  p.max_radius = 6;              // 12 is as fast on the bunny
  return p;
}

// Sets the thickness that is given by a number, a function, or a length.
template <typename Thickness, typename Network, typename Point_3>
void set_thickness(Filling_task<Point_3>& task,
                   const Thickness& thickness,
                   const Network& curve,
                   double default_thickness)
{
  if constexpr(std::is_arithmetic<Thickness>::value) {
    task.parameters.thickness = static_cast<double>(thickness);
    if(thickness == 0) task.parameters.thickness = default_thickness;
  } else {
    task.thickness = thickness;
    double sum = 0;
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) sum += task.thickness(curve.point(v));
    task.parameters.thickness = sum / static_cast<double>(curve.number_of_nodes());
  }
}

template <typename NamedParameters, typename Network>
Filling_task<typename Network::Point_3> get_filling_task(const NamedParameters& np,
                                                         const Network& curve,
                                                         double widest_radius,
                                                         double volume)
{
  namespace names = Volume_filling_curves::internal_np;
  constexpr double default_share = 0.25;  // of the widest ball
  constexpr double coarsest_share = 0.25; // likewise: the curve needs room to grow
  Filling_task<typename Network::Point_3> task;
  task.parameters = get_flow_parameters_but_thickness(np, filling_defaults());
  task.rules = get_stop_rules(np);
  task.length = parameter_or(np, names::length, 0.);
  if(!(task.length >= 0 && std::isfinite(task.length)))
    throw std::invalid_argument("the length must be positive and finite");
  const double default_thickness = task.length > 0
                                       ? std::sqrt(filling_density * volume / task.length)
                                       : default_share * widest_radius;
  set_thickness(
      task,
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, names::thickness), 0.),
      curve, default_thickness);
  if(task.length > 0 && task.thickness)
    throw std::invalid_argument("either a length or a thickness that varies can be asked for");
  task.coarsest_thickness = coarsest_share * widest_radius;
  return task;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_TASK_H
