// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/silhouette_path.h"

#include "pictures/svg_number.h"

#include <cstddef>

namespace vfc {
namespace {

// The edges of front faces, except those between two front faces.
Directed_edges outline_of(const Triangle_soup& surface)
{
  Directed_edges front_edges, outline;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if(!(surface.area_normal(t).z() < 0)) continue; // y points downwards
    const auto& [a, b, c] = surface.triangles[t];
    front_edges.insert({{a, b}, {b, c}, {c, a}});
  }
  for(const auto& [v, w] : front_edges)
    if(front_edges.count({w, v}) == 0) outline.insert({v, w});
  return outline;
}

} // namespace

std::string silhouette_path(const Triangle_soup& surface)
{
  return loops_path(outline_of(surface), surface.points);
}

std::string loops_path(Directed_edges edges, const std::vector<Vector>& points)
{
  std::string path;
  while(!edges.empty()) {
    const std::size_t start = edges.begin()->first;
    path += 'M' + svg_coordinates(points[start]);
    std::size_t v = start;
    do {
      const auto edge = edges.lower_bound({v, 0});
      if(edge == edges.end() || edge->first != v) break; // the surface is open
      v = edge->second;
      edges.erase(edge);
      if(v != start) path += 'L' + svg_coordinates(points[v]);
    } while(v != start);
    path += 'Z';
  }
  return path;
}

} // namespace vfc
