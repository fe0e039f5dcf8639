// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SHELLS_H
#define VFC_SHELLS_H

#include "meshes/Mesh_findings.h"
#include "meshes/Mesh_soup.h"

#include <vector>

namespace vfc {

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

#endif // VFC_SHELLS_H
