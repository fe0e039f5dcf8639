// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TRIANGLE_SOUP_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TRIANGLE_SOUP_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Vector.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The triangles of a surface as pictures need them: points, and three indices per triangle.
struct Triangle_soup
{
  std::vector<Vector> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  // twice the area times the unit normal
  Vector area_normal(std::size_t t) const
  {
    const auto [a, b, c] = triangles[t];
    return (points[b] - points[a]).cross(points[c] - points[a]);
  }

  // what a closed surface encloses
  double volume() const
  {
    double sum = 0;
    for(const auto& [a, b, c] : triangles)
      sum += (points[a] - points[0]).cross(points[b] - points[0]).dot(points[c] - points[0]);
    return std::abs(sum) / 6;
  }
};

// Faces with more than three vertices become fans.
template <typename TriangleMesh>
Triangle_soup triangle_soup(const TriangleMesh& mesh)
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const auto point = get(CGAL::vertex_point, mesh);
  Triangle_soup soup;
  std::map<Vertex, std::size_t> index;
  for(const Vertex v : vertices(mesh)) {
    index[v] = soup.points.size();
    soup.points.push_back(to_vector(get(point, v)));
  }
  for(const auto f : faces(mesh)) {
    std::vector<std::size_t> corners;
    for(const Vertex v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(index[v]);
    for(std::size_t i = 2; i < corners.size(); ++i)
      soup.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
  return soup;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TRIANGLE_SOUP_H
