// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_OF_CURVE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_OF_CURVE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Polygon_projection.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Nodes of closed curves in order. \throws std::invalid_argument if a component is open or has a
// junction
template <typename Network>
Closed_polygons closed_polygons(const Network& curve)
{
  Closed_polygons polygons;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    if(!curve.is_closed(c) || has_junction(curve, c))
      throw std::invalid_argument("component " + std::to_string(c) +
                                  " is not a closed curve, and has no diagram");
    for(const std::size_t e : edges_along(curve, c))
      polygons.points.push_back(to_vector(curve.point(curve.source(e))));
    polygons.close();
  }
  return polygons;
}

// Direction k of a sequence that is uniform on the sphere and has no symmetries.
inline Viewing_direction viewing_direction(std::size_t k)
{
  constexpr double scale = 1 << 20; // two directions differ by 1e-6 or are the same
  const Vector d = Random_source(k).direction() * scale;
  return {int(std::lround(d.x())), int(std::lround(d.y())), int(std::lround(d.z()))};
}

// Diagram with the fewest crossings among several directions, or that of the first direction if it
// has very many; none if the polygons meet, and hence no direction is generic.
// \throws Run_stopped in a Watched_scope
inline std::optional<Planar_diagram> find_diagram(const Closed_polygons& polygons,
                                                  std::size_t number_of_directions)
{
  // Of 10,000 directions, none is refused for an embedded curve, on a lattice or not.
  constexpr std::size_t max_refused = 20;
  std::optional<Planar_diagram> best;
  std::size_t seen = 0, refused = 0;
  while(seen < number_of_directions || !best) {
    auto diagram = Polygon_projection(polygons, viewing_direction(seen + refused))();
    if(diagram) {
      ++seen;
      if(!best || diagram->crossings.size() < best->crossings.size()) best = std::move(diagram);
    } else if(++refused == max_refused)
      return std::nullopt;
  }
  return best;
}

// The same. \throws std::invalid_argument if the polygons meet
inline Planar_diagram best_diagram(const Closed_polygons& polygons,
                                   std::size_t number_of_directions)
{
  auto diagram = find_diagram(polygons, number_of_directions);
  if(!diagram) throw std::invalid_argument("the curve has no generic projection: it meets itself");
  return std::move(*diagram);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_OF_CURVE_H
