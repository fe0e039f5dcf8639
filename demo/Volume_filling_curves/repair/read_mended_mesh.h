// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_READ_MENDED_MESH_H
#define VFC_READ_MENDED_MESH_H

#include "files/mesh_files.h"

#include <string>

namespace vfc {

// Reads a mesh, and mends it by repair_mesh() with `alpha` if it has errors and all of them can be
// mended. Tells the user and the report what was done, also that nothing had to be. A mended mesh
// has no origins. \throws Input_error
Mesh_and_defects read_mended_mesh(Session& session, const std::string& file, double alpha = 0);

} // namespace vfc

#endif // VFC_READ_MENDED_MESH_H
