// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_OUTSIDE_PARTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_OUTSIDE_PARTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The nodes and the edges of a curve that are not strictly inside a domain, in their order. An edge
// with any point on or beyond the boundary is outside.
struct Outside_parts
{
  std::vector<std::size_t> nodes, edges;
};

// As exact as the domain is. Takes the time of a point test per node and a triangle test per edge.
template <typename Network, typename Domain>
Outside_parts outside_parts(const Network& curve, const Domain& domain)
{
  Outside_parts result;
  std::vector<bool> is_inside(curve.number_of_nodes());
  for(std::size_t v = 0; v < is_inside.size(); ++v) {
    is_inside[v] = domain.is_inside(curve.point(v));
    if(!is_inside[v]) result.nodes.push_back(v);
  }
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const std::size_t v = curve.source(e), w = curve.target(e);
    if(!is_inside[v] || !domain.is_triangle_inside(curve.point(v), curve.point(w), curve.point(w)))
      result.edges.push_back(e);
  }
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_OUTSIDE_PARTS_H
