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

// The outline of a surface in picture coordinates, as the path of an SVG file: closed loops of the
// edges between a front face and a back face. The loops run around the front faces: their winding
// number at a point of the picture is the number of front faces there, and a fill with the rule
// "nonzero" paints exactly the area that the surface covers. O(n log n).
std::string silhouette_path(const Triangle_soup& surface);

// The pairs of points that are joined.
using Directed_edges = std::set<std::pair<std::size_t, std::size_t>>;

// Joins edges that follow one another to loops, as the path of an SVG file.
std::string loops_path(Directed_edges edges, const std::vector<Vector>& points);

// The edges at which a surface is creased, without those of its outline: paths of an SVG file.
struct Crease_paths
{
  std::string front, back; // between faces that are turned to the viewer, and away from him
};

// Creases of a surface in picture coordinates. Without them a box looks like the hexagon that it
// covers. Both are empty if there are so many creases that they would hide the curve. O(n log n).
Crease_paths crease_paths(const Triangle_soup& surface);

} // namespace vfc

#endif // VFC_SURFACE_PATHS_H
