// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_EXAMINE_MESH_H
#define VFC_EXAMINE_MESH_H

#include "files/mesh_files.h"
#include "meshes/Mesh_findings.h"
#include "meshes/Mesh_soup.h"
#include "meshes/Watched_points.h"

namespace vfc {

// Examines whether triangles bound a domain. The findings may already have errors of the file's
// text; the result does not contain the defects. \throws Work_stopped
Mesh_and_defects examine(Mesh_soup soup, Mesh_findings& findings, Work_watch& watch);
Mesh_and_defects examine(Mesh_soup soup, Mesh_findings& findings); // for as long as it takes

// returns the faces of a mesh, numbered as they are in a file of it
Mesh_soup soup_of(const Mesh& mesh);

// Returns whether a mesh bounds a domain without changes. \throws Work_stopped
bool is_sound(const Mesh& mesh, Work_watch& watch);

} // namespace vfc

#endif // VFC_EXAMINE_MESH_H
