// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/support/Deadline.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// How far points inside a domain are from its boundary. After the deadline, if there is one, the
// distances are left at 0, but for that of the first point.
template <typename ConcurrencyTag = Sequential_tag, typename Domain>
std::vector<double> boundary_distances(const Domain& domain,
                                       const std::vector<typename Domain::Point_3>& points,
                                       const Deadline* deadline = nullptr)
{
  constexpr std::size_t block = 256;
  std::vector<double> distances(points.size(), 0);
  for_each_block<ConcurrencyTag>(points.size(), block, [&](std::size_t begin, std::size_t end) {
    for(std::size_t k = begin; k < end; ++k)
      if(k == 0 || !deadline || !deadline->has_passed()) distances[k] = domain.distance(points[k]);
  });
  return distances;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H
