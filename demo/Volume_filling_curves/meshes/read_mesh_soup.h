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

// returns whether files with this extension hold surfaces, or may
bool is_mesh_extension(const std::string& extension);

// Adds what is wrong with the text of a file, in the words for meshes.
void add_errors(const Defect_list& defects, Mesh_findings& findings);

// Reads points and faces, those of OBJ and STL files through CGAL, and cuts faces with more than
// three corners into triangles: a fan, which is right for convex ones; for others the check for
// self-intersections has the last word.
Mesh_soup read_mesh_soup(const std::string& file, Mesh_findings& findings);

} // namespace vfc

#endif // VFC_READ_MESH_SOUP_H
