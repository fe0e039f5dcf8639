// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/corner_normals.h"

#include <cstddef>

namespace vfc {

std::vector<Vector> corner_normals(const Triangle_soup& soup)
{
  constexpr double crease_cosine = 0.7; // 45 degrees
  std::vector<Vector> face_normals;
  std::vector<std::vector<std::size_t>> faces_at(soup.points.size());
  for(std::size_t t = 0; t < soup.triangles.size(); ++t) {
    face_normals.push_back(soup.area_normal(t));
    for(const std::size_t v : soup.triangles[t]) faces_at[v].push_back(t);
  }
  std::vector<Vector> normals;
  for(std::size_t t = 0; t < soup.triangles.size(); ++t)
    for(const std::size_t v : soup.triangles[t]) {
      Vector sum = Vector::Zero();
      for(const std::size_t other : faces_at[v]) {
        const Vector &m = face_normals[t], &n = face_normals[other];
        if(m.dot(n) >= crease_cosine * m.norm() * n.norm()) sum += n;
      }
      normals.push_back(sum);
    }
  return normals;
}

} // namespace vfc
