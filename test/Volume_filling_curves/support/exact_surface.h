// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_EXACT_SURFACE_H
#define VFC_TEST_EXACT_SURFACE_H

#include "support/exact_brute_force.h"
#include "support/mesh_test_support.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// The surface of a domain as a plain list of triangles, all of which are asked every time, in
// rational arithmetic where something is decided: what the package says about domains and about
// curves inside them, counted again in another way.
namespace exact_surface {

using meshes::Point;
using meshes::Soup;
using Rational = CGAL::Exact_rational;
using Exact_point = brute_force::Vec<Rational>;
using brute_force::operator-;

inline Exact_point to_exact(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

class Surface
{
public:
  explicit Surface(const Soup& soup)
  {
    for(const auto& [a, b, c] : soup.faces) {
      const std::array<Point, 3> corners = {soup.points[a], soup.points[b], soup.points[c]};
      m_faces.push_back({corners,
                         {to_exact(corners[0]), to_exact(corners[1]), to_exact(corners[2])},
                         CGAL::bbox_3(corners.begin(), corners.end())});
    }
  }

  // returns whether the convex hull of some points has a point on the surface
  bool does_meet(const std::vector<Point>& hull) const
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(hull.begin(), hull.end());
    std::vector<Exact_point> exact;
    for(const Point& p : hull) exact.push_back(to_exact(p));
    return std::any_of(m_faces.begin(), m_faces.end(), [&](const Face& face) {
      return CGAL::do_overlap(box, face.box) && brute_force::do_hulls_meet(exact, face.exact);
    });
  }

  // returns whether p is inside: a ray crosses the surface an odd number of times
  bool is_inside(const Point& p) const
  {
    if(does_meet({p})) return false;
    for(int x = 1;; x += 2)
      if(const auto is_odd = has_odd_crossings(to_exact(p), {x, 1009, 757})) return *is_odd;
  }

  double distance(const Point& p) const
  {
    double least = std::numeric_limits<double>::infinity();
    for(const Face& face : m_faces)
      least = (std::min)(
          least, CGAL::squared_distance(p, meshes::Kernel::Triangle_3(
                                               face.corners[0], face.corners[1], face.corners[2])));
    return std::sqrt(least);
  }

  // returns how many nodes of a network, and how many of its edges, are not strictly inside
  template <typename Network>
  std::array<std::size_t, 2> count_outside(const Network& network) const
  {
    std::array<std::size_t, 2> count = {0, 0};
    for(const auto& p : network.points()) count[0] += !is_inside(p);
    for(const std::size_t e : network.edges()) {
      const Point &p = network.point(network.source(e)), &q = network.point(network.target(e));
      count[1] += does_meet({p, q}) || !is_inside(p);
    }
    return count;
  }

private:
  struct Face
  {
    std::array<Point, 3> corners;
    std::vector<Exact_point> exact;
    CGAL::Bbox_3 box;
  };

  // nothing if the ray meets an edge, or the line through it
  std::optional<bool> has_odd_crossings(const Exact_point& p, const Exact_point& ray) const
  {
    bool is_odd = false;
    for(const Face& face : m_faces) {
      const Exact_point a = face.exact[0] - p, b = face.exact[1] - p, c = face.exact[2] - p;
      const Rational sides[] = {brute_force::det(ray, a, b), brute_force::det(ray, b, c),
                                brute_force::det(ray, c, a)};
      const auto [least, most] = std::minmax_element(sides, sides + 3);
      if(*least < 0 && *most > 0) continue;
      if(*least == 0 || *most == 0) return std::nullopt;
      if((brute_force::det(a, b, c) > 0) == (*least > 0)) is_odd = !is_odd;
    }
    return is_odd;
  }

  std::vector<Face> m_faces;
};

// Voxels whose grid planes along an axis stand at other places than at the integers.
inline Soup stretched(Soup soup, std::size_t axis, const std::vector<double>& places)
{
  for(Point& p : soup.points) {
    std::array<double, 3> x = {p.x(), p.y(), p.z()};
    x[axis] = places[static_cast<std::size_t>(x[axis])];
    p = {x[0], x[1], x[2]};
  }
  return soup;
}

inline Soup scaled(Soup soup, double scale)
{
  for(Point& p : soup.points) p = {scale * p.x(), scale * p.y(), scale * p.z()};
  return soup;
}

// Three cubes around a corner, in the plane z = 0.
inline Soup corner_piece()
{
  return meshes::voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

// Two legs of height 3 and width 1, joined at the bottom, with a wall of that thickness between
// them.
inline Soup two_legs(double wall)
{
  const Soup soup =
      meshes::voxels({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}});
  return stretched(soup, 0, {0, 1, 1 + wall, 2 + wall});
}

// Two cubes of side 1 joined by a neck of width 0.2 and length 0.8.
inline Soup two_chambers()
{
  std::vector<std::array<int, 3>> cubes = {{5, 2, 2}, {6, 2, 2}, {7, 2, 2}, {8, 2, 2}};
  for(int x = 0; x < 5; ++x)
    for(int y = 0; y < 5; ++y)
      for(int z = 0; z < 5; ++z) {
        cubes.push_back({x, y, z});
        cubes.push_back({x + 9, y, z});
      }
  return meshes::voxels(cubes, 0.2);
}

} // namespace exact_surface

#endif // VFC_TEST_EXACT_SURFACE_H
