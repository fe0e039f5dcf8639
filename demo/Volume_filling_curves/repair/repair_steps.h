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

// Steps that mend a mesh, in their order, each in its own file. A step leaves a mesh without its
// kind of defect unchanged, and returns a description of its repairs. A mesh has no garbage:
// indices are below its numbers of vertices and faces. CGAL's functions throw on unexpected input;
// Work_stopped is thrown at the request of the watch. Both leave an unusable mesh.

// Merges points at the same position, drops faces that use a vertex twice or occur twice, and
// orients the others consistently. O(n log n).
std::string assemble_faces(const Mesh_soup& soup, Mesh& mesh, Work_watch& watch);

// Merges vertices of borders that are closer than 1e-6 of the mesh's diagonal: equal points that an
// exporter rounded differently.
std::string merge_near_vertices(Mesh& mesh, Work_watch& watch);

// Drops components that are not closed if they have at most 1 % of the area, such as fins.
std::string drop_sheets(Mesh& mesh, Work_watch& watch);

// Removes faces whose corners lie on a line, by moves of edges.
std::string remove_flat_faces(Mesh& mesh, Work_watch& watch);

// Closes holes of at most 2000 edges, each by triangles between its vertices. Holes that touch in a
// vertex are closed one by one.
std::string close_holes(Mesh& mesh, Work_watch& watch);

// Cuts out the faces of each shell that intersect others of it, and closes the gaps; where that
// makes new intersections, with ever more faces around them. Near linear in the number of faces.
std::string remove_self_intersections(Mesh& mesh, Work_watch& watch);

// Replaces closed shells that intersect, or are nested with the same orientation, by the surface of
// their union; shells with the opposite orientation of the largest one are subtracted.
std::string unite_shells(Mesh& mesh, Work_watch& watch);

// Last resort, after holes are closed: a surface around all faces, at a distance of alpha / 30,
// which enters no gap narrower than alpha (Portaneri et al., Alpha wrapping with an offset, 2022),
// and no cavity.
std::string wrap_faces(double alpha, Mesh& mesh, Work_watch& watch);

} // namespace vfc

#endif // VFC_REPAIR_STEPS_H
