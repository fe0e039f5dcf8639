// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Default_thickness.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <CGAL/assertions.h>

#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Parameters with which a flow runs: checked against the curve before anything changes, adapted to
// the dimension of the domain, and with a thickness that is measured if none is given.

// Returns the parameters with that thickness. \throws std::invalid_argument if one is out of range
template <typename Point_3>
Curve_flow_parameters checked(Curve_flow_parameters parameters, const Thickness<Point_3>& thickness)
{
  parameters.thickness = thickness.number();
  check_parameters(parameters);
  return parameters;
}

// In the plane only two directions are orthogonal to a curve. Both act along one line, like two
// pairs of opposite directions in space: half of the weight makes strands equally stiff.
template <typename Domain>
Curve_flow_parameters in_domain(Curve_flow_parameters p)
{
  if(!Space_of<Domain>::is_plane) return p;
  p.number_of_directions = 2;
  p.medial_weight /= 2;
  return p;
}

// Refuses edges so short that the curve would exhaust memory. Runs check their size before they
// start; their estimates are rough, and flows get thinner, hence the slack.
template <typename Network>
void check_number_of_nodes(const Network& curve,
                           double spacing,
                           const std::vector<double>& thickness)
{
  constexpr double slack = 4;
  if(has_too_many_nodes(length_in_units(curve, thickness) / slack, spacing, 1))
    refuse_value(internal_np::spacing_t(), spacing,
                 "the curve would have far more than 20 million nodes");
}

// Returns the thickness, measured if it is not given. \throws std::invalid_argument if the curve
// cannot flow with it and the parameters
template <typename Domain, typename ConcurrencyTag, typename Guard>
Thickness<typename Guard::Point_3> given_or_measured(const Guard& guard,
                                                     const Curve_flow_parameters& parameters,
                                                     Thickness<typename Guard::Point_3> thickness)
{
  using Network = typename Guard::Curve_network;
  const Network& curve = guard.curve();
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  check_constraints<typename Guard::Boundary>(curve);
  if(!thickness.is_given()) {
    Default_thickness<Network, ConcurrencyTag> measure(
        curve, in_domain<Domain>(parameters).number_of_directions, guard.watch());
    thickness = Thickness<typename Guard::Point_3>(measure());
    if(!thickness.is_given() && curve.number_of_edges() > 0)
      throw std::invalid_argument("the curve is too small to measure a thickness");
  }
  check_number_of_nodes(curve, parameters.spacing, thickness.at_each(curve.points()));
  return thickness;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_PARAMETERS_H
