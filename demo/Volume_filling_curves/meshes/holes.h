// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_HOLES_H
#define VFC_HOLES_H

#include "files/mesh_files.h"

#include <vector>

namespace vfc {

// A cycle of edges that have one face only.
struct Hole
{
  std::vector<Mesh::Vertex_index> vertices; // in the order of the halfedges without a face
  double width = 0;                         // the longest side of a box around them
};

// returns the holes of a mesh, the widest first
std::vector<Hole> holes_of(const Mesh& mesh);

} // namespace vfc

#endif // VFC_HOLES_H
