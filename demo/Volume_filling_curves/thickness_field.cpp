// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "thickness_field.h"

#include "errors.h"

#include <CGAL/Volume_filling_curves/IO/vertex_values.h>
#include <CGAL/Volume_filling_curves/Mesh_thickness_field_3.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

Thickness read_thickness_field(const std::string& file,
                               const std::string& mesh_file,
                               const Mesh_and_defects& mesh)
{
  // the mesh may have fewer vertices than its file, or more
  const std::size_t number_of_values = curves::internal::read_mesh_file(mesh_file).points.size();
  std::vector<double> values;
  std::vector<curves::Mesh_defect> defects;
  if(!CGAL::IO::read_vertex_values(file, number_of_values, values, defects))
    throw Input_error(make_defects(defects, file), "a thickness for every vertex");
  std::vector<double> at_vertices;
  for(const std::size_t origin : mesh.origins) at_vertices.push_back(values[origin]);
  const auto field =
      std::make_shared<const curves::Mesh_thickness_field_3<>>(mesh.mesh, at_vertices);
  return [field](const Curve::Point_3& p) { return (*field)(p); };
}

} // namespace vfc
