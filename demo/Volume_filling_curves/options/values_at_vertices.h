// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_VALUES_AT_VERTICES_H
#define VFC_VALUES_AT_VERTICES_H

#include "files/mesh_files.h"
#include "meshes/Mesh_soup.h"

#include <cstddef>
#include <vector>

namespace vfc {

// Returns the values at the vertices of a mesh, given those of all vertices in its file. A mended
// mesh has vertices that are not in the file: they take the value of the nearest point of the faces
// there, as the field has it.
template <typename Field, typename Value>
std::vector<Value> values_at_vertices(const Mesh_and_defects& mesh,
                                      const std::vector<Value>& values)
{
  std::vector<Value> result;
  for(const std::size_t origin : mesh.origins) result.push_back(values[origin]);
  if(mesh.unmended == nullptr) return result;
  Mesh faces; // apart from each other, whatever is wrong with them
  std::vector<Value> at_corners;
  const auto& points = mesh.unmended->points;
  for(const auto& [u, v, w] : mesh.unmended->faces) {
    if(CGAL::collinear(points[u], points[v], points[w])) continue;
    const auto corner = [&](std::size_t k) {
      at_corners.push_back(values[k]);
      return faces.add_vertex(points[k]);
    };
    const auto a = corner(u), b = corner(v), c = corner(w); // in this order
    faces.add_face(a, b, c);
  }
  const Field field(faces, at_corners);
  for(const auto& p : mesh.mesh.points()) result.push_back(field(p));
  return result;
}

} // namespace vfc

#endif // VFC_VALUES_AT_VERTICES_H
