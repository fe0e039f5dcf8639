// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TUBE_FILES_H
#define VFC_TUBE_FILES_H

#include "files/curve_files.h"
#include "files/mesh_files.h"

#include <cstddef>
#include <string>

namespace vfc {

// Plans to write the surface of a tube, .stl, .off, .ply or .obj. \throws Usage_error
void add_tube_file(Output_files& outputs, const std::string& option, const std::string& file);

// \throws Usage_error if the curve has a junction
Mesh tube(const Curve& curve, double radius, std::size_t number_of_sides);

// Notes the unit, if it is not empty, in the header of an .stl file. \throws Usage_error
void write_tube(const std::string& file, const Mesh& mesh, const std::string& unit = "");

} // namespace vfc

#endif // VFC_TUBE_FILES_H
