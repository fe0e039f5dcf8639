// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_COMBINED_SHELLS_H
#define VFC_COMBINED_SHELLS_H

#include "meshes/Watched_points.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vfc {

struct Combined_shells
{
  Mesh surface;             // empty where CGAL meets what it does not expect
  std::size_t cavities = 0; // the shells that were taken away
};

// Returns the surface of the union of shells, oriented like the largest one. Shells with the
// opposite orientation are subtracted from the union of the others. \throws Work_stopped
// \pre the shells are closed, and none intersects itself
Combined_shells combined(std::vector<Mesh> shells, Work_watch& watch);

// Return the surface of the difference, or of the intersection, of two meshes, or nothing if CGAL
// reports unexpected input or the result touches itself in an edge. \throws Work_stopped
// \pre both bound a domain
std::optional<Mesh> difference(Mesh mesh, Mesh other, Work_watch& watch);
std::optional<Mesh> intersection(Mesh mesh, Mesh other, Work_watch& watch);

} // namespace vfc

#endif // VFC_COMBINED_SHELLS_H
