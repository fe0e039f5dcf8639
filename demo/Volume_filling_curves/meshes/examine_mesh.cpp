// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/examine_mesh.h"

#include "meshes/mesh_checks.h"

#include <cstddef>
#include <numeric>
#include <utility>

namespace vfc {

Mesh_and_defects examine(Mesh_soup soup, Mesh_findings& findings, Work_watch& watch)
{
  Mesh_and_defects result;
  result.number_of_vertices_in_file = soup.points.size();
  if(!findings.has_error() || findings.is_mendable()) check_soup(soup, findings, watch);
  if(!soup.faces.empty() && !soup.file_indices.empty())
    result.mesh = closed_surface(soup, findings, watch);
  result.is_valid = !findings.has_error();
  if(!result.is_valid) result.mesh.clear();
  for(const auto& p : result.mesh.points()) result.origins.push_back(soup.file_indices.at(p));
  return result;
}

Mesh_and_defects examine(Mesh_soup soup, Mesh_findings& findings)
{
  Work_watch no_limit;
  return examine(std::move(soup), findings, no_limit);
}

Mesh_soup soup_of(const Mesh& mesh)
{
  Mesh_soup soup;
  soup.points.assign(mesh.points().begin(), mesh.points().end());
  for(const Mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    soup.faces.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
  soup.face_numbers.resize(soup.faces.size());
  std::iota(soup.face_numbers.begin(), soup.face_numbers.end(), std::size_t(1));
  return soup;
}

bool is_sound(const Mesh& mesh, Work_watch& watch)
{
  Mesh_findings findings("");
  return examine(soup_of(mesh), findings, watch).is_valid;
}

} // namespace vfc
