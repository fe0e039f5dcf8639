// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_THICKNESS_FIELD_H
#define VFC_THICKNESS_FIELD_H

#include "files/mesh_files.h"
#include "reports/coverage_report.h"

#include <string>

namespace vfc {

// Reads a thickness for each vertex of the file of a mesh: the vertex property `thickness` of a PLY
// file, or the lines of a CSV file. At a point the thickness is that of the closest point of the
// surface, linear in each face. \throws Input_error
Thickness read_thickness_field(const std::string& file, const Mesh_and_defects& mesh);

} // namespace vfc

#endif // VFC_THICKNESS_FIELD_H
