// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/edge_values.h"

#include "pictures/strands.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
using Tag = CGAL::Parallel_if_available_tag;

Edge_values components(const Curve& curve)
{
  Edge_values values;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const auto component = static_cast<double>(curve.component(curve.source(e)));
    values.push_back({component, component});
  }
  return values;
}

// Two values per edge, not one per node: a closed curve ends with its length where it starts with
// 0.
Edge_values arclengths(const Curve& curve)
{
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(has_junction(curve, c))
      throw Usage_error("--color arclength: component " + std::to_string(c + 1) +
                        " has a junction, and no length along it");
  Edge_values values(curve.number_of_edges());
  for(const Strand& strand : strands_of(curve)) {
    double length = 0;
    for(const std::size_t e : strand.edges) {
      const Vector along =
          to_vector(curve.point(curve.target(e))) - to_vector(curve.point(curve.source(e)));
      values[e] = {length, length + along.norm()};
      length += along.norm();
    }
  }
  return values;
}

Edge_values at_both_nodes(const Curve& curve, const std::vector<double>& values)
{
  Edge_values result;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    result.push_back({values[curve.source(e)], values[curve.target(e)]});
  return result;
}

// Calls measure(cap) for radii up to a relevant cap; they are 0 if the curve has no extent.
template <typename Measure>
Edge_values capped_radii(const Curve& curve, const Measure& measure)
{
  const double cap = 2 * curves::default_thickness<Tag>(curve);
  return at_both_nodes(curve,
                       cap > 0 ? measure(cap) : std::vector<double>(curve.number_of_nodes(), 0.));
}

} // namespace

Edge_values edge_values(const Curve& curve, Coloring coloring)
{
  switch(coloring) {
  case Coloring::COMPONENT:
    return components(curve);
  case Coloring::ARCLENGTH:
    return arclengths(curve);
  case Coloring::CURVATURE:
    return at_both_nodes(curve, curves::node_curvatures(curve));
  case Coloring::RADIUS:
    return capped_radii(curve, [&](double cap) { return curves::medial_radii<Tag>(curve, cap); });
  case Coloring::THICKNESS:
    return capped_radii(curve,
                        [&](double cap) { return curves::min_medial_radii<Tag>(curve, cap); });
  }
  return {};
}

} // namespace vfc
