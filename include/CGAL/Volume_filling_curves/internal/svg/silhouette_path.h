// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SVG_SILHOUETTE_PATH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SVG_SILHOUETTE_PATH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Triangle_soup.h>
#include <CGAL/Volume_filling_curves/internal/svg/svg_number.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The outline of a surface in picture coordinates, as the path of an SVG file: closed loops of the
// edges between a face that is turned to the viewer and one that is not. The loops run around the
// faces that are turned to the viewer, so that they wind around each point of the picture as often as
// layers of these lie there, and a fill with the rule "nonzero" paints just what the surface covers.
// O(n log n).
inline std::string silhouette_path(const Triangle_soup& surface)
{
  using Edge = std::pair<std::size_t, std::size_t>;
  std::set<Edge> front_edges;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if(!(surface.area_normal(t).z() < 0)) continue; // y points downwards
    const auto& [a, b, c] = surface.triangles[t];
    front_edges.insert({{a, b}, {b, c}, {c, a}});
  }
  std::set<Edge> outline;
  for(const auto& [v, w] : front_edges)
    if(front_edges.count({w, v}) == 0) outline.insert({v, w});
  std::string path;
  while(!outline.empty()) {
    const std::size_t start = outline.begin()->first;
    path += 'M' + svg_coordinates(surface.points[start]);
    std::size_t v = start;
    do {
      const auto edge = outline.lower_bound({v, 0});
      if(edge == outline.end() || edge->first != v) break; // the surface is open
      v = edge->second;
      outline.erase(edge);
      if(v != start) path += 'L' + svg_coordinates(surface.points[v]);
    } while(v != start);
    path += 'Z';
  }
  return path;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SVG_SILHOUETTE_PATH_H
