// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TRIANGLE_SOUP_H
#define VFC_TRIANGLE_SOUP_H

#include "files/mesh_files.h"
#include "pictures/Vector.h"

#include <array>
#include <cstddef>
#include <vector>

namespace vfc {

// The triangles of a surface as pictures need them: points, and three indices per triangle.
struct Triangle_soup
{
  Triangle_soup() = default;
  explicit Triangle_soup(const Mesh& mesh);

  // twice the area times the unit normal
  Vector area_normal(std::size_t t) const;

  // what a closed surface encloses
  double volume() const;

  std::vector<Vector> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// The normals with which a surface is shaded, three per triangle: the mean of those of the
// triangles around the corner that are not beyond a crease. Linear time for vertices of bounded
// degree.
std::vector<Vector> corner_normals(const Triangle_soup& soup);

} // namespace vfc

#endif // VFC_TRIANGLE_SOUP_H
