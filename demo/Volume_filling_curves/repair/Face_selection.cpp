// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/Face_selection.h"

#include "meshes/mesh_checks.h"

#include <algorithm>

namespace vfc {

Face_selection::Face_selection(const Mesh& mesh, Work_watch& watch)
    : m_has(mesh.number_of_faces(), false)
{
  for(const auto& [f, g] : intersecting_faces(mesh, watch)) m_has[f] = m_has[g] = true;
}

bool Face_selection::is_empty() const
{
  return std::find(m_has.begin(), m_has.end(), true) == m_has.end();
}

std::vector<Mesh::Vertex_index> Face_selection::vertices(const Mesh& mesh) const
{
  std::vector<Mesh::Vertex_index> result;
  for(const Mesh::Face_index f : mesh.faces())
    if(has(f))
      for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        result.push_back(v);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void Face_selection::add_ring(const Mesh& mesh)
{
  for(const Mesh::Vertex_index v : vertices(mesh))
    for(const Mesh::Face_index f : mesh.faces_around_target(mesh.halfedge(v)))
      if(f != Mesh::null_face()) m_has[f] = true;
}

} // namespace vfc
