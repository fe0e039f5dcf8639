// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NEAR_JUNCTIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NEAR_JUNCTIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tells which nodes are less than `reach` away from a junction, along the network: there the medial
// spheres see the sibling branches, which get arbitrarily close, and would blow them up. Dijkstra's
// algorithm from all junctions at once; O(n log n), constant time without junctions.
template <typename Network>
std::vector<bool> near_junctions(const Network& curve,
                                 const Vector_field& x,
                                 const std::vector<double>& thickness)
{
  using Item = std::pair<double, std::size_t>;
  std::vector<bool> is_near(curve.number_of_nodes(), false);
  if(!curve.has_junction()) return is_near;
  std::vector<double> distance(curve.number_of_nodes(), std::numeric_limits<double>::infinity());
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.degree(v) > 2) queue.emplace(distance[v] = 0, v);
  while(!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if(is_near[v]) continue;
    is_near[v] = true;
    for(std::size_t k = 0; k < curve.degree(v); ++k) {
      const std::size_t w = curve.neighbor(v, k);
      const double farther = d + 2 * (row(x, w) - row(x, v)).norm() / (thickness[v] + thickness[w]);
      if(farther >= distance[w] || farther >= 1) continue;
      queue.emplace(distance[w] = farther, w);
    }
  }
  return is_near;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NEAR_JUNCTIONS_H
