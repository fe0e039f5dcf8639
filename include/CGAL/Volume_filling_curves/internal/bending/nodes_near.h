// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_NODES_NEAR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_NODES_NEAR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Marks the nodes that are at most `reach` edges away from some nodes, not past ends and junctions.
template <typename Network>
void mark_along(const Network& curve,
                const std::vector<std::size_t>& nodes,
                std::size_t reach,
                std::vector<bool>& marks)
{
  for(const std::size_t v : nodes) {
    marks[v] = true;
    for(std::size_t k = 0; k < curve.degree(v); ++k) {
      std::size_t last = v, next = curve.neighbor(v, k);
      for(std::size_t i = 1; i <= reach; ++i) {
        marks[next] = true;
        if(curve.degree(next) != 2) break;
        const std::size_t after_next =
            curve.neighbor(next, curve.neighbor(next, 0) == last ? 1 : 0);
        last = next;
        next = after_next;
      }
    }
  }
}

// Returns which nodes are near some nodes: along the curve, and along the strands next to these.
// Linear in the number of pairs.
template <typename Network>
std::vector<bool> nodes_near(const Network& curve,
                             const Strand_pairs& pairs,
                             const std::vector<std::size_t>& nodes)
{
  constexpr std::size_t reach = 8; // half a turn of the tightest bend takes six edges of a filling
  std::vector<bool> marks(curve.number_of_nodes(), false);
  mark_along(curve, nodes, reach, marks);
  std::vector<std::size_t> beside;
  for(const auto& [e, f] : pairs.pairs())
    for(const auto& [near, other] :
        {std::pair(pairs.ends(e), pairs.ends(f)), std::pair(pairs.ends(f), pairs.ends(e))})
      if((marks[near[0]] || marks[near[1]]) && !(marks[other[0]] && marks[other[1]]))
        beside.insert(beside.end(), other.begin(), other.end());
  mark_along(curve, beside, reach, marks);
  return marks;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_NODES_NEAR_H
