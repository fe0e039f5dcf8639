// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_VERTEX_FIELDS_H
#define VFC_VERTEX_FIELDS_H

#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "meshes/Mesh_soup.h"
#include "reports/coverage_report.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace vfc {

// Reads a thickness for each vertex of the file of a mesh: the vertex property `thickness` of a PLY
// file, or the lines of a CSV file. At a point the thickness is that of the closest point of the
// surface, linear in each face. \throws Input_error
Thickness read_thickness_field(const std::string& file, const Mesh_and_defects& mesh);

// A direction at each point; none by default.
using Direction_field = std::function<std::array<double, 3>(const Curve::Point_3&)>;

// Whether an argument is a vector `x,y,z` rather than a file.
bool is_vector(const std::string& text);

// The same direction everywhere, if the argument is a vector; or else reads a vector for each
// vertex of the file of a mesh: the vertex properties `direction_x`, `direction_y` and
// `direction_z` of a PLY file, or the lines of a CSV file. \throws Input_error
Direction_field make_direction_field(const std::string& text, const Mesh_and_defects& mesh);

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

#endif // VFC_VERTEX_FIELDS_H
