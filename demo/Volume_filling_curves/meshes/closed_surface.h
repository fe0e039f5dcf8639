// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CLOSED_SURFACE_H
#define VFC_CLOSED_SURFACE_H

#include "meshes/Mesh_findings.h"
#include "meshes/Mesh_soup.h"
#include "meshes/Watched_points.h"

namespace vfc {

// Construction of a mesh that bounds a domain from triangles, and search for obstacles to that:
// edges of one or of more than two faces, and faces that meet elsewhere than in a common vertex or
// edge. Where the surface touches itself in a vertex, the mesh has several vertices. Faces are
// oriented with normals out of the domain; a shell within an odd number of others bounds a cavity.
// All decisions are exact. O(n log^2 n) unless many faces have intersecting boxes. \throws
// Work_stopped \pre no triangle is degenerate
Mesh closed_surface(Mesh_soup& soup, Mesh_findings& findings, Work_watch& watch);

} // namespace vfc

#endif // VFC_CLOSED_SURFACE_H
