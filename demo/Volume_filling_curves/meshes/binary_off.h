// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BINARY_OFF_H
#define VFC_BINARY_OFF_H

#include "files/mesh_files.h"
#include "meshes/Mesh_findings.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace vfc {

// returns whether a text is an OFF file in binary form
bool is_binary_off(std::string_view text);

// Reads it: whole numbers and floats of four bytes, the highest byte first; a face has the number
// of its corners, these, and the number of the values of its color, which are skipped. CGAL 5.5
// misreads their faces.
void read_binary_off(std::string_view text,
                     std::vector<Kernel::Point_3>& points,
                     std::vector<std::vector<std::size_t>>& polygons,
                     Mesh_findings& findings);

} // namespace vfc

#endif // VFC_BINARY_OFF_H
