// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_OVERLAPPING_PROJECTIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_OVERLAPPING_PROJECTIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/box_intersection_d.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Candidates for the crossings of a projected curve: calls f(e, g), e < g, once for every two edges
// whose boxes in the plane, enlarged by `margin`, overlap. CGAL's streamed segment trees report the
// k pairs in O(n log n + k).
template <typename Network, typename Function>
void for_each_overlap_of_projected_edges(const Network& curve,
                                         const std::vector<Eigen::Vector2d>& projection,
                                         double margin,
                                         const Function& f)
{
  using Flat_box = Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  std::vector<Flat_box> boxes;
  boxes.reserve(curve.number_of_edges());
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const Eigen::Vector2d &p = projection[curve.source(e)], &q = projection[curve.target(e)];
    Eigen::Vector2d low = p.cwiseMin(q).array() - margin, high = p.cwiseMax(q).array() + margin;
    boxes.emplace_back(low.data(), high.data(), e);
  }
  box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Flat_box& a, const Flat_box& b) {
    f((std::min)(a.info(), b.info()), (std::max)(a.info(), b.info()));
  });
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_OVERLAPPING_PROJECTIONS_H
