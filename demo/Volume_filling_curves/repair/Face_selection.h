// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FACE_SELECTION_H
#define VFC_FACE_SELECTION_H

#include "meshes/Watched_points.h"

#include <vector>

namespace vfc {

// Some of the faces of a mesh.
class Face_selection
{
public:
  // Selects the faces that meet others elsewhere than in a common vertex or edge.
  // \pre the mesh has no garbage \throws Work_stopped
  Face_selection(const Mesh& mesh, Work_watch& watch);

  bool is_empty() const;
  bool has(Mesh::Face_index f) const { return m_has[f]; }

  // the vertices of the faces, in order
  std::vector<Mesh::Vertex_index> vertices(const Mesh& mesh) const;

  // Adds the faces that have a vertex in common with others of the selection.
  void add_ring(const Mesh& mesh);

private:
  std::vector<bool> m_has;
};

} // namespace vfc

#endif // VFC_FACE_SELECTION_H
