// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_MESH_TEST_SUPPORT_H
#define VFC_TEST_MESH_TEST_SUPPORT_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Small meshes made in place, as points and triangles.
namespace meshes {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = std::array<std::size_t, 3>;

struct Soup
{
  std::vector<Point> points;
  std::vector<Face> faces;

  Soup& operator+=(const Soup& other)
  {
    const std::size_t first = points.size();
    points.insert(points.end(), other.points.begin(), other.points.end());
    for(const Face& f : other.faces) faces.push_back({f[0] + first, f[1] + first, f[2] + first});
    return *this;
  }

  Soup inverted() const
  {
    Soup result = *this;
    for(Face& f : result.faces) std::swap(f[1], f[2]);
    return result;
  }
};

inline Soup operator+(Soup a, const Soup& b)
{
  return a += b;
}

inline Mesh to_mesh(const Soup& soup)
{
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  return mesh;
}

// The surface of a union of unit cubes with these lower corners, all faces outward, two triangles
// per square. Which of the two diagonals a square gets varies.
inline Soup voxels(const std::vector<std::array<int, 3>>& cubes, double scale = 1)
{
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> vertices;
  const auto vertex = [&](const std::array<int, 3>& x) {
    const auto [it, is_new] = vertices.insert({x, soup.points.size()});
    if(is_new) soup.points.emplace_back(scale * x[0], scale * x[1], scale * x[2]);
    return it->second;
  };
  const auto is_full = [&](const std::array<int, 3>& x) {
    for(const auto& cube : cubes)
      if(cube == x) return true;
    return false;
  };
  for(const auto& cube : cubes) {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      for(const int side : {0, 1}) {
        std::array<int, 3> neighbor = cube;
        neighbor[axis] += side == 1 ? 1 : -1;
        if(is_full(neighbor)) continue;
        const auto corner = [&](int u, int v) {
          std::array<int, 3> x = cube;
          x[axis] += side;
          x[(axis + 1) % 3] += u;
          x[(axis + 2) % 3] += v;
          return vertex(x);
        };
        std::array<std::size_t, 4> square = {corner(0, 0), corner(1, 0), corner(1, 1),
                                             corner(0, 1)};
        if(side == 0) std::swap(square[1], square[3]);
        const std::size_t turn = static_cast<std::size_t>(cube[0] + cube[1] + cube[2]) % 2;
        const auto at = [&](std::size_t i) { return square[(i + turn) % 4]; };
        soup.faces.push_back({at(0), at(1), at(2)});
        soup.faces.push_back({at(0), at(2), at(3)});
      }
    }
  }
  return soup;
}

inline Soup cube(double side = 1)
{
  return voxels({{0, 0, 0}}, side);
}

// An octahedron, refined by cutting every triangle into four and pushed onto a sphere.
inline Soup sphere(double radius, int refinements, const Point& center = Point(0, 0, 0))
{
  Soup soup;
  soup.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for(int k = 0; k < refinements; ++k) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    std::vector<Face> finer;
    const auto middle = [&](std::size_t i, std::size_t j) {
      const auto [it, is_new] = middles.insert({std::minmax(i, j), soup.points.size()});
      if(is_new) soup.points.push_back(CGAL::midpoint(soup.points[i], soup.points[j]));
      return it->second;
    };
    for(const auto& [a, b, c] : soup.faces) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for(const Face& f : {Face{a, ab, ca}, Face{ab, b, bc}, Face{ca, bc, c}, Face{ab, bc, ca}})
        finer.push_back(f);
    }
    soup.faces = finer;
  }
  for(Point& p : soup.points) {
    const Kernel::Vector_3 v = p - CGAL::ORIGIN;
    p = center + radius / std::sqrt(v.squared_length()) * v;
  }
  return soup;
}

} // namespace meshes

#endif // VFC_TEST_MESH_TEST_SUPPORT_H
