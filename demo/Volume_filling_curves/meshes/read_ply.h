// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_READ_PLY_H
#define VFC_READ_PLY_H

#include "files/mesh_files.h"
#include "meshes/Mesh_findings.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {

// Reads the points of a PLY file, which are x, y and z of element vertex, and the polygons: the
// list vertex_indices, or vertex_index, of element face, or of element tristrips, in which -1 ends
// a strip of triangles. Everything else is passed over.
void read_ply_surface(std::string_view text,
                      std::vector<Kernel::Point_3>& points,
                      std::vector<std::vector<std::size_t>>& polygons,
                      Mesh_findings& findings);

// Returns the values that a PLY file has for a property of the vertices. A word that is no number
// is among the findings.
std::vector<double> read_ply_column(std::string_view text,
                                    const std::string& property,
                                    Mesh_findings& findings);

} // namespace vfc

#endif // VFC_READ_PLY_H
