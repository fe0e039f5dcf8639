// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/vertex_fields.h"

#include "meshes/vertex_values.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/Mesh_fields_3.h>

#include <vector>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

Thickness read_thickness_field(const std::string& file, const Mesh_and_defects& mesh)
{
  Mesh_findings findings(file);
  const std::vector<double> values =
      read_vertex_values(file, "thickness", mesh.number_of_vertices_in_file, findings);
  if(findings.has_error()) throw Input_error(findings.list(), "a thickness for every vertex");
  using Field = curves::Mesh_thickness_field_3<>;
  return Field(mesh.mesh, values_at_vertices<Field>(mesh, values));
}

bool is_vector(const std::string& text)
{
  std::array<double, 3> vector;
  return parse_vector(text, vector);
}

Direction_field make_direction_field(const std::string& text, const Mesh_and_defects& mesh)
{
  std::array<double, 3> vector;
  if(parse_vector(text, vector)) return [vector](const Curve::Point_3&) { return vector; };
  Mesh_findings findings(text);
  const auto vectors = read_vertex_vectors(text, {"direction_x", "direction_y", "direction_z"},
                                           mesh.number_of_vertices_in_file, findings);
  if(findings.has_error())
    throw Input_error(findings.list(), "a vector x,y,z, or a file with one for every vertex");
  using Field = curves::Mesh_direction_field_3<>;
  return Field(mesh.mesh, values_at_vertices<Field>(mesh, vectors));
}

} // namespace vfc
