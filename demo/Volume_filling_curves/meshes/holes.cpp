// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/holes.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/border.h>

#include <algorithm>
#include <iterator>

namespace vfc {
namespace {

Hole hole_at(const Mesh& mesh, Mesh::Halfedge_index border)
{
  Hole hole;
  CGAL::Bbox_3 box;
  for(const Mesh::Halfedge_index h : halfedges_around_face(border, mesh)) {
    hole.vertices.push_back(mesh.target(h));
    box += mesh.point(mesh.target(h)).bbox();
  }
  hole.width = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  return hole;
}

} // namespace

std::vector<Hole> holes_of(const Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  std::vector<Hole> holes;
  for(const Mesh::Halfedge_index border : borders) holes.push_back(hole_at(mesh, border));
  std::stable_sort(holes.begin(), holes.end(),
                   [](const Hole& a, const Hole& b) { return a.width > b.width; });
  return holes;
}

} // namespace vfc
