// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_REPAIR_MESH_H
#define VFC_REPAIR_MESH_H

#include "meshes/Mesh_soup.h"
#include "session/Work_watch.h"

#include <string>
#include <vector>

namespace vfc {

// The repairs of a mesh, step by step, and how far they moved its surface: the greatest distances
// of points of either surface from the other one, which are estimated from some 10,000 points.
struct Mending
{
  std::vector<std::string> steps;
  double from_file = 0; // of the mended surface from that in the file
  double to_mended = 0; // of the surface in the file from the mended one, which may leave out parts
};

// Mends a mesh: by the steps that change least, and only if these do not suffice by wrapping it. Of
// gaps narrower than `alpha`, in the unit of the mesh, wrapping does not enter any; 0 stands for a
// fiftieth of the mesh's diagonal. The result is sound, unless no face has an area.
// \throws Work_stopped
Mending repair_mesh(const Mesh_soup& soup, double alpha, Mesh& mesh, Work_watch& watch);

} // namespace vfc

#endif // VFC_REPAIR_MESH_H
