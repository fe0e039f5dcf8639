// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_VERTEX_VALUES_H
#define VFC_VERTEX_VALUES_H

#include "meshes/Mesh_findings.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace vfc {

// Reads one positive number per vertex of a mesh, in the order of the mesh's file. A PLY file has
// them in a vertex property; any other file is read as text with one number per line, of which the
// first may be a header. Blank lines and lines that start with # are ignored.
std::vector<double> read_vertex_values(const std::string& file,
                                       const std::string& property,
                                       std::size_t number_of_vertices,
                                       Mesh_findings& findings);

// Reads one vector of any length per vertex in the same way: three properties, or three numbers per
// line, separated by commas, semicolons or blanks.
std::vector<std::array<double, 3>> read_vertex_vectors(const std::string& file,
                                                       const std::array<std::string, 3>& properties,
                                                       std::size_t number_of_vertices,
                                                       Mesh_findings& findings);

// Returns whether the text consists of three finite numbers with these separators.
bool parse_vector(const std::string& text, std::array<double, 3>& vector);

} // namespace vfc

#endif // VFC_VERTEX_VALUES_H
