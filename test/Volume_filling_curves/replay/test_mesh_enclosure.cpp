// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/replay/Mesh_enclosure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <vector>

// The mesh enclosure of a replay, compared with all faces one by one in rational arithmetic.
namespace test_mesh_enclosure {

namespace internal = CGAL::Volume_filling_curves::internal;
using internal::Position;
using internal::Random_source;
using internal::replay::faces_of_closed_mesh;
using internal::replay::Mesh_enclosure;
using meshes::Point;
using meshes::Soup;

Position position(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

// Meshes and points are made near the origin, with halves for coordinates, and brought elsewhere.
struct Placement
{
  double scale = 1, offset = 0;

  Point operator()(const Point& p) const { return {at(p.x()), at(p.y()), at(p.z())}; }

private:
  double at(double x) const { return scale * x + offset; }
};

// Where lattices of doubles are as coarse as here, few points lie between a mesh and its box.
constexpr Placement far_away{2, 4503599627370496.}; // 2^52

// Corners, edges, faces and grid planes are hit often.
Point lattice_point(Random_source& random, std::size_t n)
{
  const auto coordinate = [&] { return static_cast<double>(random.index(n)) / 2; };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

Point near(const Point& p, Random_source& random)
{
  const Point step = lattice_point(random, 5);
  return {p.x() + step.x() - 1, p.y() + step.y() - 1, p.z() + step.z() - 1};
}

Soup placed(Soup soup, const Placement& place)
{
  for(Point& p : soup.points) p = place(p);
  return soup;
}

// Compares points and triangles, some of which are degenerate.
void compare(const Soup& soup, std::size_t seed, const Placement& place = {})
{
  const Soup there = placed(soup, place);
  const Mesh_enclosure enclosure(faces_of_closed_mesh(meshes::to_mesh(there)));
  const exact_surface::Surface surface(there);
  Random_source random(seed);
  int number_inside = 0, number_outside = 0;
  for(int k = 0; k < 600; ++k) {
    const Point a = lattice_point(random, 9), b = near(a, random);
    const Point c = k % 5 == 0 ? b : near(a, random);
    const Point p = place(a), q = place(b), r = place(c);
    ASSERT_EQ(enclosure.is_inside(position(p)), surface.is_inside(p)) << a;
    if(!surface.is_inside(p)) continue;
    const bool is_inside = !surface.does_meet({p, q, r});
    ASSERT_EQ(enclosure.is_triangle_inside({position(p), position(q), position(r)}), is_inside)
        << a << ", " << b << ", " << c;
    ++(is_inside ? number_inside : number_outside);
  }
  EXPECT_GT(number_inside, 20);
  EXPECT_GT(number_outside, 20);
}

// A cube of side 4, of which each side is a fan of 16 triangles around its center.
Soup cube_of_fans()
{
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> vertices;
  const auto vertex = [&](std::size_t axis, int x, int y, int z) {
    std::array<int, 3> p;
    p[axis] = x;
    p[(axis + 1) % 3] = y;
    p[(axis + 2) % 3] = z;
    const auto [it, is_new] = vertices.insert({p, soup.points.size()});
    if(is_new) soup.points.emplace_back(p[0], p[1], p[2]);
    return it->second;
  };
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const int side : {0, 4}) {
      std::vector<std::size_t> rim;
      for(int i = 0; i < 4; ++i) rim.push_back(vertex(axis, side, i, 0));
      for(int i = 0; i < 4; ++i) rim.push_back(vertex(axis, side, 4, i));
      for(int i = 4; i > 0; --i) rim.push_back(vertex(axis, side, i, 4));
      for(int i = 4; i > 0; --i) rim.push_back(vertex(axis, side, 0, i));
      if(side == 0) std::reverse(rim.begin(), rim.end());
      for(std::size_t i = 0; i < rim.size(); ++i)
        soup.faces.push_back({vertex(axis, side, 2, 2), rim[i], rim[(i + 1) % rim.size()]});
    }
  return soup;
}

TEST(Mesh_enclosure, decides_as_brute_force_on_lattices)
{
  compare(meshes::cube(4), 1);
  compare(meshes::voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, 2), 2);
}

// A segment from a point inside to one of the points beyond, of which there are a few, always met
// an edge; another one was tried for ever.
TEST(Long_mesh_enclosure, decides_as_brute_force_where_coordinates_are_large)
{
  compare(cube_of_fans(), 5);
  compare(cube_of_fans(), 5, far_away);
  compare(meshes::voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, 2), 6, far_away);
}

TEST(Mesh_enclosure, knows_cavities)
{
  Soup cavity = meshes::cube(1).inverted();
  for(Point& p : cavity.points) p = {p.x() + 1.5, p.y() + 1.5, p.z() + 1.5};
  compare(meshes::cube(4) + cavity, 3);
  compare(meshes::cube(4) + cavity, 3, far_away);
}

TEST(Mesh_enclosure, decides_in_curved_domains)
{
  compare(meshes::sphere(2, 1, Point(2, 2, 2)), 4);
}

TEST(Mesh_enclosure, refuses_what_bounds_nothing)
{
  Soup open = meshes::cube();
  open.faces.pop_back();
  EXPECT_THROW(faces_of_closed_mesh(meshes::to_mesh(open)), std::invalid_argument);
  EXPECT_THROW(faces_of_closed_mesh(meshes::Mesh()), std::invalid_argument);
}

} // namespace test_mesh_enclosure
