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
