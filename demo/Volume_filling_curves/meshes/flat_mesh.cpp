// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/flat_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>

#include <map>

namespace vfc {

Mesh flat_mesh(const std::vector<CGAL::Polygon_with_holes_2<Kernel>>& polygons)
{
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
  const CGAL::Volume_filling_curves::Polygon_domain_3<> domain(polygons);
  Triangulation triangulation;
  const auto add = [&](const auto& ring) {
    triangulation.insert_constraint(ring.vertices_begin(), ring.vertices_end(), true);
  };
  for(const auto& polygon : polygons) {
    add(polygon.outer_boundary());
    for(auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) add(*hole);
  }
  Mesh mesh;
  std::map<Triangulation::Vertex_handle, Mesh::Vertex_index> vertices;
  for(auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
    vertices[v] = mesh.add_vertex(Kernel::Point_3(v->point().x(), v->point().y(), 0));
  for(auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    const auto middle = CGAL::centroid(triangulation.triangle(f));
    if(domain.is_inside(Kernel::Point_3(middle.x(), middle.y(), 0)))
      mesh.add_face(vertices[f->vertex(0)], vertices[f->vertex(1)], vertices[f->vertex(2)]);
  }
  return mesh;
}

} // namespace vfc
