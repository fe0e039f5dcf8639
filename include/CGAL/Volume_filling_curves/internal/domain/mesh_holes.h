// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_HOLES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_HOLES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/border.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Hole of a mesh: a cycle of edges with one face each.
template <typename Mesh>
struct Mesh_hole
{
  std::vector<typename Mesh::Vertex_index> vertices; // in the order of halfedges without a face
  double width = 0;                                  // the longest side of a box around them
};

template <typename Mesh>
Mesh_hole<Mesh> hole_at(const Mesh& mesh, typename Mesh::Halfedge_index border)
{
  Mesh_hole<Mesh> hole;
  CGAL::Bbox_3 box;
  for(const auto h : halfedges_around_face(border, mesh)) {
    hole.vertices.push_back(mesh.target(h));
    box += mesh.point(mesh.target(h)).bbox();
  }
  hole.width = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  return hole;
}

// returns the holes of a mesh, the widest first
template <typename Mesh>
std::vector<Mesh_hole<Mesh>> holes_of(const Mesh& mesh)
{
  std::vector<typename Mesh::Halfedge_index> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  std::vector<Mesh_hole<Mesh>> holes;
  for(const auto border : borders) holes.push_back(hole_at(mesh, border));
  std::stable_sort(holes.begin(), holes.end(),
                   [](const auto& a, const auto& b) { return a.width > b.width; });
  return holes;
}

// returns the fault that a hole is, with its size and position
template <typename Mesh>
Mesh_fault hole_fault(const Mesh& mesh, const Mesh_hole<Mesh>& hole)
{
  std::string width;
  append_number(width, hole.width, 6);
  const auto first = *std::min_element(
      hole.vertices.begin(), hole.vertices.end(),
      [&](const auto& v, const auto& w) { return mesh.point(v) < mesh.point(w); });
  return {"open boundary", "the surface is not closed: a boundary of " +
                               counted(hole.vertices.size(), "edge") + " with one face only, " +
                               width + " wide," + near_text(mesh.point(first))};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_HOLES_H
