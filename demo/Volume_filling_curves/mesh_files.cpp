// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "mesh_files.h"

#include "Session.h"

#include <CGAL/Volume_filling_curves/IO/domain_mesh.h>

#include <fstream>
#include <sstream>
#include <utility>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

Mesh_and_defects read_mesh_and_defects(const std::string& file)
{
  Mesh_and_defects result;
  std::vector<curves::Mesh_defect> defects;
  result.is_valid = CGAL::IO::read_domain_mesh(file, result.mesh, defects, result.origins);
  result.defects = make_defects(defects, file);
  return result;
}

Mesh_and_defects read_mesh(Session& session, const std::string& file)
{
  Mesh_and_defects read = read_mesh_and_defects(file);
  if(!read.is_valid) throw Input_error(std::move(read.defects), "a valid mesh");
  print_defects(session.console(), read.defects);
  session.end_stage("reading");
  return read;
}

bool is_mesh_file(const std::string& file)
{
  const std::string extension = curves::internal::lower_case_extension(file);
  if(extension != ".obj") return curves::internal::is_mesh_extension(extension);
  std::ifstream lines(file);
  bool has_faces = false;
  for(std::string line, keyword; std::getline(lines, line);) {
    std::istringstream words(line);
    if(!(words >> keyword)) continue;
    if(keyword == "l") return false;
    has_faces = has_faces || keyword == "f";
  }
  return has_faces;
}

} // namespace vfc
