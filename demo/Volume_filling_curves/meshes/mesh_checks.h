// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_MESH_CHECKS_H
#define VFC_MESH_CHECKS_H

#include "meshes/Mesh_findings.h"
#include "meshes/Mesh_soup.h"
#include "meshes/Watched_points.h"

#include <utility>
#include <vector>

namespace vfc {

// The checks of a mesh, in their order; each has a file of its own. All decisions are exact.

// Check of single points and triangles, which merges equal points and drops points without a face.
// Degenerate triangles are errors, and are removed for subsequent checks. O(n log n).
// \throws Work_stopped
void check_soup(Mesh_soup& soup, Mesh_findings& findings, Work_watch& watch);

// Construction of a mesh that bounds a domain from triangles, and search for obstacles to that:
// edges of one or of more than two faces, and faces that meet elsewhere than in a common vertex or
// edge. Where the surface touches itself in a vertex, the mesh has several vertices. Faces are
// oriented with normals out of the domain; a shell within an odd number of others bounds a cavity.
// O(n log^2 n) unless many faces have intersecting boxes. \throws Work_stopped
// \pre no triangle is degenerate
Mesh closed_surface(Mesh_soup& soup, Mesh_findings& findings, Work_watch& watch);

// Returns whether the faces around each vertex form one cycle with consistent orientation: the
// surface is closed, and does not touch itself in an edge or vertex. Takes a tenth of the time of
// CGAL's test, which orients the faces.
bool is_closed_and_oriented(const Mesh_soup& soup);

using Face_pair = std::pair<Mesh::Face_index, Mesh::Face_index>;

// Returns the pairs of faces that meet elsewhere than in a common vertex or edge, in order, up to a
// million of them. Vertices at the same position count as one. \throws Work_stopped
std::vector<Face_pair> intersecting_faces(const Mesh& mesh, Work_watch& watch);

// Reports these pairs. \throws Work_stopped \pre the mesh has the soup's points and faces
void report_self_intersections(const Mesh& mesh,
                               const Mesh_soup& soup,
                               Mesh_findings& findings,
                               Work_watch& watch);

// Orientation of the shells of a closed surface, which are its components: a shell within an odd
// number of others bounds a cavity and is oriented inward, all others outward. A whole nest with
// the wrong orientation is reversed, with a warning. A shell with the orientation of the shell
// around it is an error, since its author may have meant two solids or a cavity; unless faces of
// one of the two were oriented against their neighbors, `is_turned`, and no orientation was meant.
// \pre the shells do not intersect; the mesh has the soup's points and faces
void orient_shells(Mesh& mesh,
                   const std::vector<bool>& is_turned,
                   const Mesh_soup& soup,
                   Mesh_findings& findings);

} // namespace vfc

#endif // VFC_MESH_CHECKS_H
