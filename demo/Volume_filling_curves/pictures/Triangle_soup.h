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

// Triangles of a surface for pictures: points, and three indices per triangle.
struct Triangle_soup
{
  Triangle_soup() = default;
  explicit Triangle_soup(const Mesh& mesh);

  // twice the area times the unit normal
  Vector area_normal(std::size_t t) const;

  // the volume that a closed surface encloses
  double volume() const;

  std::vector<Vector> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// Returns the normals for shading a surface, three per triangle: at each corner the mean over the
// triangles around it that no crease separates. Linear time for vertices of bounded degree.
std::vector<Vector> corner_normals(const Triangle_soup& soup);

} // namespace vfc

#endif // VFC_TRIANGLE_SOUP_H
