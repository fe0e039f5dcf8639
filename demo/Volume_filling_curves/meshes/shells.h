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

// Orients the shells of a closed surface, which are its components: one within an odd number of
// others bounds a cavity and is turned inward, all others outward. A whole nest that is turned the
// wrong way is turned inside out, with a warning. A shell that is turned like the one around it is
// an error, since its author may have meant two solids or a cavity; unless faces of one of the two
// had been turned against their neighbors, `is_turned`, so that nothing can have been meant.
// \pre the shells do not intersect; the mesh has the soup's points and faces
void orient_shells(Mesh& mesh,
                   const std::vector<bool>& is_turned,
                   const Mesh_soup& soup,
                   Mesh_findings& findings);

} // namespace vfc

#endif // VFC_SHELLS_H
