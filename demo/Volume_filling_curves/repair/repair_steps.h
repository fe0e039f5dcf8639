// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_REPAIR_STEPS_H
#define VFC_REPAIR_STEPS_H

#include "meshes/Mesh_soup.h"
#include "meshes/Watched_points.h"

#include <string>

namespace vfc {

// The steps by which a mesh is mended, in the order in which they are taken; each is in a file of
// its own. Every one does nothing where nothing is to be done, and returns in words what it did. A
// mesh has no garbage, so that indices stay below its numbers of vertices and faces.
// CGAL's functions throw where they meet what they do not expect; Work_stopped is thrown when the
// watch wants it. Either leaves a mesh that is not to be used.

// Merges points at the same place, drops faces that use a vertex twice or stand there twice, and
// orients the others as neighbors of each other. O(n log n).
std::string assemble_faces(const Mesh_soup& soup, Mesh& mesh);

// Merges vertices of borders that are closer than 1e-6 of the mesh's diagonal: the same place after
// rounding, as exporters leave it.
std::string merge_near_vertices(Mesh& mesh, Work_watch& watch);

// Drops components that are not closed if they have at most 1 % of the area, such as fins.
std::string drop_sheets(Mesh& mesh, Work_watch& watch);

// Takes out faces whose corners lie on a line, by moves of edges.
std::string remove_flat_faces(Mesh& mesh, Work_watch& watch);

// Closes holes of at most 2000 edges, each by triangles between its vertices. Holes that touch in a
// vertex are closed one by one.
std::string close_holes(Mesh& mesh, Work_watch& watch);

// Cuts out the faces of each shell that intersect others of it, and closes the gaps; where that
// makes new intersections, with ever more faces around them. Near linear in the number of faces.
std::string remove_self_intersections(Mesh& mesh, Work_watch& watch);

// Replaces closed shells that intersect, or of which one is within the other and turned the same
// way, by the surface of their union; those that are turned the other way than the largest one are
// taken away from it.
std::string unite_shells(Mesh& mesh, Work_watch& watch);

// The last resort, when holes are closed: a surface around whatever the faces are, at a distance of
// alpha / 30 from them, which enters no gap narrower than alpha (Portaneri et al., Alpha wrapping
// with an offset, 2022), and no cavity.
std::string wrap_faces(double alpha, Mesh& mesh, Work_watch& watch);

} // namespace vfc

#endif // VFC_REPAIR_STEPS_H
