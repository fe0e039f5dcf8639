// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPLIT_TOUCHING_VERTICES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPLIT_TOUCHING_VERTICES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/Face_edges.h>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Gives every umbrella of triangles around a vertex a vertex of its own, as a mesh with halfedges needs
// it where a surface touches itself. The additional points go to the end, `origins` with them. Returns
// the origins of the vertices that were split. O(n log n).
// \pre every edge has exactly two triangles
template <typename Point>
std::vector<std::size_t> split_touching_vertices(std::vector<Point>& points,
                                                 std::vector<std::array<std::size_t, 3>>& faces,
                                                 std::vector<std::size_t>& origins)
{
  // corners 3 f + i that share a vertex and an edge belong to one umbrella
  Disjoint_sets umbrellas(3 * faces.size());
  const auto corner = [&](std::size_t f, std::size_t v) {
    return 3 * f + (faces[f][0] == v ? 0 : faces[f][1] == v ? 1 : 2);
  };
  Face_edges(faces).for_each_edge([&](auto first, auto) {
    for(const std::size_t v : {first->low, first->high})
      umbrellas.unite(corner(first->face, v), corner((first + 1)->face, v));
  });
  std::map<std::size_t, std::size_t> vertex_of; // for umbrellas beyond the first of a vertex
  std::vector<std::size_t> first(points.size(), 3 * faces.size()), split;
  for(std::size_t f = 0; f < faces.size(); ++f) {
    for(std::size_t i = 0; i < 3; ++i) {
      std::size_t& v = faces[f][i];
      const std::size_t umbrella = umbrellas.find(3 * f + i);
      if(first[v] == 3 * faces.size()) first[v] = umbrella;
      if(first[v] == umbrella) continue;
      const auto [it, is_new] = vertex_of.insert({umbrella, points.size()});
      if(is_new) {
        points.push_back(Point(points[v]));
        origins.push_back(std::size_t(origins[v]));
        if(split.empty() || split.back() != origins[v]) split.push_back(origins[v]);
      }
      v = it->second;
    }
  }
  return split;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPLIT_TOUCHING_VERTICES_H
