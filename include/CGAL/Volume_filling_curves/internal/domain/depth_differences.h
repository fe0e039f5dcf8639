// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_DIFFERENCES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_DIFFERENCES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Differences of the distance from the boundary between the points a step before and behind x along
// the axes that are asked for: 2 steps times the gradient, which has a length of 1 near a single
// wall, less near several, and 0 halfway between two. Every domain has them.
// \pre the step is shorter than the distance at x
template <typename Domain, typename Traits>
Vector depth_differences(const Domain& domain,
                         const Vector& x,
                         double step,
                         const std::array<bool, 3>& is_axis,
                         const Traits& traits)
{
  const auto depth_at = [&](int axis, double offset) {
    Vector p = x;
    p[axis] += offset;
    return domain.distance(to_point(p, traits));
  };
  Vector differences;
  for(std::size_t i = 0; i < 3; ++i)
    if(is_axis[i]) {
      const int axis = static_cast<int>(i);
      differences[axis] = depth_at(axis, step) - depth_at(axis, -step);
    }
  return differences;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_DIFFERENCES_H
