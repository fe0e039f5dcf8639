// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEAN_RADIUS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEAN_RADIUS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The mean of the radii of medial spheres along a curve, each of them capped at `largest`, at the
// nodes v for which counts(v) holds; 0 if there are none. Takes the nodes' shares of the length.
template <typename Predicate>
double mean_radius(const Medial_spheres& spheres,
                   const std::vector<double>& node_weights,
                   double largest,
                   const Predicate& counts)
{
  double sum = 0, sum_of_weights = 0;
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    const auto& circle = spheres.circles()[c];
    if(!counts(circle.node)) continue;
    const double weight = node_weights[circle.node] * circle.share;
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      sum += weight * (std::min)(spheres.radius(c, l), largest);
      sum_of_weights += weight;
    }
  }
  return sum_of_weights > 0 ? sum / sum_of_weights : 0;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEAN_RADIUS_H
