// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Triangle_soup.h"

#include <Eigen/Geometry>

#include <cmath>

namespace vfc {

Triangle_soup::Triangle_soup(const Mesh& mesh)
{
  for(const auto& p : mesh.points()) points.push_back(to_vector(p));
  for(const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    triangles.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
}

Vector Triangle_soup::area_normal(std::size_t t) const
{
  const auto& [a, b, c] = triangles[t];
  return (points[b] - points[a]).cross(points[c] - points[a]);
}

double Triangle_soup::volume() const
{
  double sum = 0;
  for(const auto& [a, b, c] : triangles)
    sum += (points[a] - points[0]).cross(points[b] - points[0]).dot(points[c] - points[0]);
  return std::abs(sum) / 6;
}

} // namespace vfc
