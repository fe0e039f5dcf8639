// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SHELLS_APART_H
#define VFC_SHELLS_APART_H

#include "files/mesh_files.h"

#include <vector>

namespace vfc {

// returns the components of a mesh as meshes of their own, in the order of their first faces
std::vector<Mesh> shells_apart(const Mesh& mesh);

// returns them as one mesh again \pre they have no garbage, which CGAL adds up wrongly
Mesh shells_together(const std::vector<Mesh>& shells);

} // namespace vfc

#endif // VFC_SHELLS_APART_H
