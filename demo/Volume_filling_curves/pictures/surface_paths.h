// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SURFACE_PATHS_H
#define VFC_SURFACE_PATHS_H

#include "pictures/Triangle_soup.h"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vfc {

// Returns the outline of a surface in picture coordinates, as the path of an SVG file: closed loops
// of the edges between a front face and a back face. The loops run around the front faces: their
// winding number at a point of the picture is the number of front faces there, and a fill with the
// rule "nonzero" paints exactly the area that the surface covers. O(n log n).
std::string silhouette_path(const Triangle_soup& surface);

// Edges as pairs of point indices.
using Directed_edges = std::set<std::pair<std::size_t, std::size_t>>;

// Joins successive edges into loops. Returns the path of an SVG file.
std::string loops_path(Directed_edges edges, const std::vector<Vector>& points);

// Creases of a surface, without its outline, as paths of an SVG file.
struct Crease_paths
{
  std::string front, back; // between faces that face the viewer, and those that do not
};

// Returns the creases of a surface in picture coordinates. Without them a box looks like a hexagon.
// Both paths are empty if the creases would be so many as to hide the curve. O(n log n).
Crease_paths crease_paths(const Triangle_soup& surface);

} // namespace vfc

#endif // VFC_SURFACE_PATHS_H
