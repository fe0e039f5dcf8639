// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CORNER_NORMALS_H
#define VFC_CORNER_NORMALS_H

#include "pictures/Triangle_soup.h"

#include <vector>

namespace vfc {

// The normals with which a surface is shaded, three per triangle: the mean of those of the
// triangles around the corner that are not beyond a crease. Linear time for vertices of bounded
// degree.
std::vector<Vector> corner_normals(const Triangle_soup& soup);

} // namespace vfc

#endif // VFC_CORNER_NORMALS_H
