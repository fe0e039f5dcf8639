// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_REGULAR_POLYGON_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_REGULAR_POLYGON_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/geometry/cos_sin.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Returns a regular polygon in the plane z = 0 around the origin.
// \throws std::invalid_argument for fewer than 3 nodes, or a radius that is not positive and finite
inline Polygon regular_polygon(std::size_t number_of_nodes, double radius)
{
  if(number_of_nodes < 3) throw std::invalid_argument("a polygon needs at least 3 nodes");
  if(!(radius > 0 && std::isfinite(radius)))
    throw std::invalid_argument("the radius of a polygon must be positive and finite");
  Polygon polygon;
  for(std::size_t k = 0; k < number_of_nodes; ++k) {
    const auto [x, y] = cos_sin(static_cast<double>(k) / static_cast<double>(number_of_nodes));
    polygon.push_back({radius * x, radius * y, 0});
  }
  return polygon;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_REGULAR_POLYGON_H
