// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SELF_INTERSECTIONS_H
#define VFC_SELF_INTERSECTIONS_H

#include "meshes/Mesh_findings.h"
#include "meshes/Mesh_soup.h"
#include "meshes/Watched_points.h"

#include <utility>
#include <vector>

namespace vfc {

using Face_pair = std::pair<Mesh::Face_index, Mesh::Face_index>;

// Returns the pairs of faces that meet elsewhere than in a common vertex or edge, in order, up to a
// million of them. Vertices at the same position count as one. \throws Work_stopped
std::vector<Face_pair> intersecting_faces(const Mesh& mesh, Work_watch& watch);

// Reports these pairs. \throws Work_stopped \pre the mesh has the soup's points and faces
void report_self_intersections(const Mesh& mesh,
                               const Mesh_soup& soup,
                               Mesh_findings& findings,
                               Work_watch& watch);

} // namespace vfc

#endif // VFC_SELF_INTERSECTIONS_H
