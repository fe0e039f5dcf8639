// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RESCALE_TO_LENGTH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RESCALE_TO_LENGTH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Scaling of a curve about its center to a given length; returns the factor. The steps are
// certified, since coordinates are rounded, and short if there are many nodes, which keeps the
// number of close edges low. It stops early, with the factor reached, if even a short step is
// refused, or if coarse rounding of coordinates prevents progress. A network without edges is
// unchanged.
template <typename Guard>
double rescale_to_length(Guard& guard, double wanted)
{
  constexpr double min_step = 1.001;
  constexpr double precision = 1e-12;
  const auto& curve = guard.curve();
  const double start = total_length(curve);
  if(!(start > 0)) return 1;
  const Clearance_scope<Guard> scope(guard, 0);
  const double max_step =
      1 + 1 / std::sqrt(std::sqrt(static_cast<double>(curve.number_of_nodes())));
  double step = max_step, error = std::numeric_limits<double>::infinity();
  for(double rest = wanted / start; std::abs(rest - 1) > precision && std::abs(rest - 1) < error;) {
    const double factor = std::clamp(rest, 1 / step, step);
    Vector_field x = coordinates(curve);
    const Vector center = centroid(x);
    for(Eigen::Index v = 0; v < x.rows(); ++v)
      set_row(x, v, factor * (row(x, v) - center) + center);
    if(guard.move_nodes(x) == 1) {
      error = std::abs(rest - 1);
      rest = wanted / total_length(curve);
      step = (std::min)(step * step, max_step); // longer again
    } else if((step = std::sqrt(step)) < min_step)
      break;
  }
  return total_length(curve) / start;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RESCALE_TO_LENGTH_H
