// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/surface_paths.h"

#include "pictures/svg_number.h"

#include <map>

namespace vfc {
namespace {

// Returns the edges of front faces, except those between two front faces.
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

// 40 degrees: an icosahedron (42 degrees) has creases, a round surface with more than nine edges
// around it has none
constexpr double crease_cosine = 0.766;
constexpr std::size_t max_creases = 500;

using Edge = std::pair<std::size_t, std::size_t>;

std::map<Edge, Vector> normals_beside_edges(const Triangle_soup& surface)
{
  std::map<Edge, Vector> normals;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Vector normal = surface.area_normal(t);
    for(const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) normals[edge] = normal;
  }
  return normals;
}

bool is_crease(const Vector& m, const Vector& n)
{
  return m.dot(n) < crease_cosine * m.norm() * n.norm() && (m.z() < 0) == (n.z() < 0);
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

Crease_paths crease_paths(const Triangle_soup& surface)
{
  Crease_paths paths;
  std::size_t count = 0;
  const std::map<Edge, Vector> normals = normals_beside_edges(surface);
  for(const auto& [edge, normal] : normals) {
    const auto& [v, w] = edge;
    const auto other = v < w ? normals.find({w, v}) : normals.end();
    if(other == normals.end() || !is_crease(normal, other->second)) continue;
    if(++count > max_creases) return {};
    std::string& path = normal.z() < 0 ? paths.front : paths.back; // y points downwards
    path += 'M' + svg_coordinates(surface.points[v]) + 'L' + svg_coordinates(surface.points[w]);
  }
  return paths;
}

} // namespace vfc
