// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/thickness_field.h"

#include "meshes/vertex_values.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/Mesh_thickness_field_3.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

Thickness read_thickness_field(const std::string& file, const Mesh_and_defects& mesh)
{
  Mesh_findings findings(file);
  const std::vector<double> values =
      read_vertex_values(file, "thickness", mesh.number_of_vertices_in_file, findings);
  if(findings.has_error()) throw Input_error(findings.list(), "a thickness for every vertex");
  std::vector<double> at_vertices;
  for(const std::size_t origin : mesh.origins) at_vertices.push_back(values[origin]);
  const auto field =
      std::make_shared<const curves::Mesh_thickness_field_3<>>(mesh.mesh, at_vertices);
  return [field](const Curve::Point_3& p) { return (*field)(p); };
}

} // namespace vfc
