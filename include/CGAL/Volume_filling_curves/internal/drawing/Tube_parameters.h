// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Parameters of tube_mesh(): the named ones, and a radius in one of several forms.

struct Tube_parameters
{
  /// The number of sides of the polygons, at least 3.
  std::size_t number_of_sides = 16;
};

constexpr auto parameter_table(const Tube_parameters*)
{
  return std::make_tuple(
      parameter<internal_np::number_of_sides_t>(&Tube_parameters::number_of_sides));
}

// \cgalParamNBegin{vertex_point_map}
//   \cgalParamDescription{a property map that sets the points of the mesh's vertices}
//   \cgalParamType{a model of `WritablePropertyMap` whose key type is the mesh's vertex descriptor
//     and whose value type is constructed from three `double` numbers}
//   \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
// \cgalParamNEnd
using Tube_tags = Tag_list<internal_np::vertex_point_map_t>;
using Tube_signature = Signature<Tube_parameters, Tube_tags>;

template <typename NamedParameters>
Tube_parameters tube_parameters(const NamedParameters& np)
{
  const auto parameters = get_parameters<Tube_signature>(np);
  if(parameters.number_of_sides < 3)
    refuse_value(internal_np::number_of_sides, parameters.number_of_sides, "must be at least 3");
  return parameters;
}

// Returns the radius at node v. The argument is a number, a function of the node, or a property
// map.
template <typename Radius>
double radius_at(const Radius& radius, std::size_t v)
{
  using boost::get;
  if constexpr(std::is_arithmetic_v<Radius>)
    return static_cast<double>(radius);
  else if constexpr(std::is_invocable_v<const Radius&, std::size_t>)
    return static_cast<double>(radius(v));
  else
    return static_cast<double>(get(radius, v));
}

[[noreturn]] inline void refuse_radius(std::size_t v, double radius, const std::string& why)
{
  std::ostringstream message;
  message.imbue(std::locale::classic());
  message << "the radius at node " << v << " is " << radius << ", " << why;
  throw std::invalid_argument(message.str());
}

// \throws std::invalid_argument if a radius is not positive and finite, or lost in rounding
template <typename Network, typename Radius>
std::vector<double> radii_of_nodes(const Network& curve, const Radius& radius)
{
  constexpr double least = 1e-12; // of the largest coordinate: some 5,000 units in the last place
  std::vector<double> radii;
  for(const std::size_t v : curve.nodes()) {
    radii.push_back(radius_at(radius, v));
    const double r = radii.back();
    if(!(r > 0) || !std::isfinite(r)) refuse_radius(v, r, "it must be positive and finite");
    if(r < least * to_vector(curve.point(v)).cwiseAbs().maxCoeff())
      refuse_radius(v, r, "so small that it is lost in the rounding of the coordinates");
  }
  return radii;
}

template <typename Network>
void refuse_junctions(const Network& curve)
{
  if(!curve.has_junction()) return;
  for(const std::size_t v : curve.nodes())
    if(curve.degree(v) > 2)
      throw std::invalid_argument("node " + std::to_string(v) + " is a junction of " +
                                  std::to_string(curve.degree(v)) +
                                  " edges, around which there is no tube");
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_PARAMETERS_H
