// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_MESH_FILES_H
#define VFC_MESH_FILES_H

#include "session/errors.h"

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace vfc {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// The inside of a mesh.
using Domain = CGAL::Volume_filling_curves::Triangle_mesh_domain_3<>;

// Parameters of a domain whose mesh has been examined.
inline const auto examined = CGAL::Volume_filling_curves::parameters::check_mesh(false);

class Session;
class Mesh_findings;
struct Mesh_soup;

// The content of the file of a closed surface. The mesh is empty if one of the defects is an error.
struct Mesh_and_defects
{
  Mesh mesh;
  std::vector<std::size_t> origins;           // the places of the vertices in the file, from 0
  std::size_t number_of_vertices_in_file = 0; // some may have been merged or left out
  std::shared_ptr<const Mesh_soup> unmended;  // of a mended mesh what the file has; no origins then
  Defects defects;
  bool is_valid = false; // no defect is an error
};

Mesh_and_defects read_mesh_and_defects(const std::string& file);

// Prints the warnings about a mesh. \throws Input_error with a line for every kind of error
void accept(Session& session, const Mesh_findings& findings);

// Reads a mesh and accepts it; no defects are left, since the warnings are printed.
// \throws Input_error
Mesh_and_defects read_mesh(Session& session, const std::string& file);

// Returns whether a file contains a surface rather than a curve: an OBJ file if it has faces and no
// lines, and other files with the extension of a surface, except PLY and VTP files with lines and
// no faces.
bool is_mesh_file(const std::string& file);

} // namespace vfc

#endif // VFC_MESH_FILES_H
