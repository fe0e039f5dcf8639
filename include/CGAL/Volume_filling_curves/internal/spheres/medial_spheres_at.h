// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERES_AT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERES_AT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Medial_sphere.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Those of node v, as users see them: with centers.
template <typename Network>
auto medial_spheres_at(const Network& curve, std::size_t v, const Medial_spheres& spheres)
{
  std::vector<Medial_sphere<typename Network::Point_3>> result;
  for(std::size_t c = spheres.first_circle(v); c < spheres.first_circle(v + 1); ++c)
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      const double radius = spheres.radius(c, l);
      const Vector center = to_vector(curve.point(v)) + radius * spheres.direction(c, l);
      result.push_back({to_point(center, curve.traits()), radius, spheres.touching_node(c, l)});
    }
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERES_AT_H
