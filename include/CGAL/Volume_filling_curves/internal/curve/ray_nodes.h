// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_RAY_NODES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_RAY_NODES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The rays that a curve has, found by what a node tells of itself: a ray leads from its tip, a
// node of degree one without an origin, through nodes without an origin to an end of the curve
// itself.

template <typename Network>
bool is_tip_of_ray(const Network& curve, std::size_t v)
{
  return curve.degree(v) == 1 && curve.origin(v) == curve.null_node();
}

template <typename Network>
std::vector<std::size_t> tips_of_rays(const Network& curve)
{
  std::vector<std::size_t> tips;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(is_tip_of_ray(curve, v)) tips.push_back(v);
  return tips;
}

// returns the nodes of a ray, from the tip to the end of the curve
template <typename Network>
std::vector<std::size_t> nodes_from_tip(const Network& curve, std::size_t tip)
{
  std::vector<std::size_t> nodes = {tip, curve.neighbor(tip, 0)};
  while(curve.origin(nodes.back()) == curve.null_node()) {
    const std::size_t v = nodes.back(), before = nodes[nodes.size() - 2];
    nodes.push_back(curve.neighbor(v, curve.neighbor(v, 0) == before ? 1 : 0));
  }
  return nodes;
}

// Takes away all rays, and leaves no garbage. Leaves the curve alone if there are none.
template <typename Network>
void remove_rays(const Network& curve, Network_editor<Network>& editor)
{
  const std::vector<std::size_t> tips = tips_of_rays(curve);
  for(std::size_t v : tips)
    while(is_tip_of_ray(curve, v)) {
      const std::size_t next = curve.neighbor(v, 0);
      editor.remove_leaf(v);
      v = next;
    }
  if(!tips.empty()) editor.collect_garbage();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_RAY_NODES_H
