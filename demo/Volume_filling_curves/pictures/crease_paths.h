// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CREASE_PATHS_H
#define VFC_CREASE_PATHS_H

#include "pictures/Triangle_soup.h"

#include <string>

namespace vfc {

// The edges at which a surface is creased, without those of its outline: paths of an SVG file.
struct Crease_paths
{
  std::string front, back; // between faces that are turned to the viewer, and away from him
};

// Creases of a surface in picture coordinates. Without them a box looks like the hexagon that it
// covers. Both are empty if there are so many creases that they would hide the curve. O(n log n).
Crease_paths crease_paths(const Triangle_soup& surface);

} // namespace vfc

#endif // VFC_CREASE_PATHS_H
