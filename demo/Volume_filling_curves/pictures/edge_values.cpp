// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/edge_values.h"

#include "pictures/strands.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/default_thickness.h>
#include <CGAL/Volume_filling_curves/internal/curve/turning.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_sphere_search.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
namespace internal = curves::internal;

Edge_values components(const Curve& curve)
{
  Edge_values values;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const auto component = static_cast<double>(curve.component(curve.source(e)));
    values.push_back({component, component});
  }
  return values;
}

// Values of edges, since a closed curve ends with its length where it starts with 0.
Edge_values arclengths(const Curve& curve)
{
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(internal::has_junction(curve, c))
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

double curvature(const Curve& curve, std::size_t v)
{
  if(curve.degree(v) != 2) return 0;
  const auto point = [&](std::size_t w) { return internal::to_vector(curve.point(w)); };
  const auto neighbor = [&](std::size_t k) {
    const std::size_t e = curve.incident_edge(v, k);
    return curve.source(e) == v ? curve.target(e) : curve.source(e);
  };
  return 1 / internal::bend_radius(point(v) - point(neighbor(0)), point(neighbor(1)) - point(v));
}

Edge_values curvatures(const Curve& curve)
{
  std::vector<double> values;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) values.push_back(curvature(curve, v));
  return at_both_nodes(curve, values);
}

enum class Statistic
{
  MEAN,
  LEAST
};

std::vector<double> medial_radii(const Curve& curve, Statistic statistic)
{
  using Tag = CGAL::Parallel_if_available_tag;
  constexpr std::size_t directions = 16;
  const double cap = 2 * curves::default_thickness<Tag>(curve, directions);
  std::vector<double> radii(curve.number_of_nodes(), cap);
  if(!(cap > 0)) return radii;
  const internal::Vector_field x = internal::coordinates(curve);
  const std::vector<double> half(curve.number_of_nodes(), cap / 2);
  internal::Medial_sphere_search search(Tag(), x, half, 2);
  const internal::Medial_spheres spheres = search(internal::node_circles(curve, x), directions);
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    double sum = 0, least = cap;
    for(std::size_t l = 0; l < directions; ++l) {
      sum += spheres.radius(c, l);
      least = (std::min)(least, spheres.radius(c, l));
    }
    double& radius = radii[spheres.circles()[c].node]; // a junction has several circles
    radius = (std::min)(radius, statistic == Statistic::MEAN ? sum / directions : least);
  }
  return radii;
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
    return curvatures(curve);
  case Coloring::RADIUS:
    return at_both_nodes(curve, medial_radii(curve, Statistic::MEAN));
  case Coloring::THICKNESS:
    return at_both_nodes(curve, medial_radii(curve, Statistic::LEAST));
  }
  return {};
}

} // namespace vfc
