// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_CAPPED_MEDIAL_SPHERES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_CAPPED_MEDIAL_SPHERES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_sphere_search.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/spheres/node_circles.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Medial spheres of a curve up to the radius `largest`, for measures, which do not depend on a
// thickness.
template <typename ConcurrencyTag, typename Network>
Medial_spheres capped_medial_spheres(const Network& curve,
                                     double largest,
                                     std::size_t number_of_directions,
                                     Run_watch* watch = nullptr)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  CGAL_precondition_msg(largest > 0 && std::isfinite(largest), "`largest` is positive and finite");
  CGAL_precondition_msg(number_of_directions > 0, "`number_of_directions` is positive");
  const Vector_field x = coordinates(curve);
  constexpr double cap =
      2; // in units of the thickness: up to that they are found in a single round
  const std::vector<double> thickness(curve.number_of_nodes(), largest / cap);
  Medial_sphere_search search(ConcurrencyTag(), x, thickness, cap, No_boundary_limit(), watch);
  return search(node_circles(curve, x), number_of_directions);
}

// The same, for functions without a status. \throws Run_interrupted
template <typename ConcurrencyTag, typename Network, typename NamedParameters>
Medial_spheres measured_medial_spheres(const Network& curve,
                                       double largest,
                                       std::size_t number_of_directions,
                                       const NamedParameters& np)
{
  return measured(np, [&](Run_watch* watch) {
    return capped_medial_spheres<ConcurrencyTag>(curve, largest, number_of_directions, watch);
  });
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_CAPPED_MEDIAL_SPHERES_H
