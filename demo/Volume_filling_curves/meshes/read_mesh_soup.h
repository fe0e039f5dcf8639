// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_READ_MESH_SOUP_H
#define VFC_READ_MESH_SOUP_H

#include "formats/readers.h"
#include "meshes/Mesh_findings.h"
#include "meshes/Mesh_soup.h"

#include <string>

namespace vfc {

// returns the extension of a file's name in lower case, such as ".off"
std::string lower_case_extension(const std::string& file);

// Returns whether files with this extension contain, or may contain, surfaces.
bool is_mesh_extension(const std::string& extension);

// Adds the defects of a file's text, with the wording for meshes.
void add_errors(const Defect_list& defects, Mesh_findings& findings);

// Reads points and faces, those of OBJ and STL files through CGAL, and divides faces with more than
// three corners into fans of triangles, which is right for convex faces; for others the check for
// self-intersections decides.
Mesh_soup read_mesh_soup(const std::string& file, Mesh_findings& findings);

} // namespace vfc

#endif // VFC_READ_MESH_SOUP_H
