// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SHELL_PLACES_H
#define VFC_SHELL_PLACES_H

#include "files/mesh_files.h"

#include <cstddef>
#include <vector>

namespace vfc {

// Where a shell, a component of a closed surface, lies among the others.
struct Shell_place
{
  bool is_outward = false;         // whether its normals point away from what it encloses
  std::vector<std::size_t> around; // the shells that enclose it, ascending
};

// Returns the places of shells, which are given by their faces. Exact, from signs only, at any
// scale; O(n log^3 n), plus the faces above one point of each shell.
// \pre the shells are closed and each is oriented; faces meet only in common vertices and edges
std::vector<Shell_place> places_of_shells(const Mesh& mesh,
                                          const std::vector<std::vector<Mesh::Face_index>>& shells);

} // namespace vfc

#endif // VFC_SHELL_PLACES_H
