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

// Repairs of a mesh, step by step, and the distance by which they moved its surface: the greatest
// distances from points of either surface to the other one, estimated from some 10,000 points.
struct Mending
{
  std::vector<std::string> steps;
  double from_file = 0; // of the mended surface from that in the file
  double to_mended = 0; // of the surface in the file from the mended one, which may leave out parts
};

// Mends a mesh by the steps that change it least, and only if these do not suffice by wrapping it.
// Wrapping does not enter gaps narrower than `alpha`, in the unit of the mesh; 0 stands for a
// fiftieth of the mesh's diagonal. The result is valid, unless no face has an area. \throws
// Work_stopped
Mending repair_mesh(const Mesh_soup& soup, double alpha, Mesh& mesh, Work_watch& watch);

} // namespace vfc

#endif // VFC_REPAIR_MESH_H
