// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_MESH_TO_TEXT_H
#define VFC_MESH_TO_TEXT_H

#include "files/mesh_files.h"
#include "meshes/Mesh_soup.h"

#include <string>

namespace vfc {

// returns whether to_text() knows the format of a file with this extension: .off, .obj or .ply
bool is_written_mesh_extension(const std::string& extension);

// Returns the text of a mesh in the format of an extension. Reading it restores the coordinates bit
// by bit. \pre the format is known; the mesh has no garbage
std::string to_text(const Mesh& mesh, const std::string& extension);
std::string to_text(const Mesh_soup& soup, const std::string& extension);

} // namespace vfc

#endif // VFC_MESH_TO_TEXT_H
