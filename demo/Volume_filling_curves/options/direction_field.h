// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_DIRECTION_FIELD_H
#define VFC_DIRECTION_FIELD_H

#include "files/curve_files.h"
#include "files/mesh_files.h"

#include <array>
#include <functional>
#include <string>

namespace vfc {

// A direction at each point; none by default.
using Direction_field = std::function<std::array<double, 3>(const Curve::Point_3&)>;

// Whether an argument is a vector `x,y,z` rather than a file.
bool is_vector(const std::string& text);

// The same direction everywhere, if the argument is a vector; or else reads a vector for each
// vertex of the file of a mesh: the vertex properties `direction_x`, `direction_y` and
// `direction_z` of a PLY file, or the lines of a CSV file. \throws Input_error
Direction_field make_direction_field(const std::string& text, const Mesh_and_defects& mesh);

} // namespace vfc

#endif // VFC_DIRECTION_FIELD_H
