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

#include <cstddef>
#include <stdexcept>

// What a replay knows of a mesh, compared with all faces one by one in rational arithmetic.
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

// Compares points and triangles, some of which are degenerate.
void compare(const Soup& soup, std::size_t seed)
{
  const Mesh_enclosure enclosure(faces_of_closed_mesh(meshes::to_mesh(soup)));
  const exact_surface::Surface surface(soup);
  Random_source random(seed);
  int number_inside = 0, number_outside = 0;
  for(int k = 0; k < 600; ++k) {
    const Point p = lattice_point(random, 9), q = near(p, random);
    const Point r = k % 5 == 0 ? q : near(p, random);
    ASSERT_EQ(enclosure.is_inside(position(p)), surface.is_inside(p)) << p;
    if(!surface.is_inside(p)) continue;
    const bool is_inside = !surface.does_meet({p, q, r});
    ASSERT_EQ(enclosure.is_triangle_inside({position(p), position(q), position(r)}), is_inside)
        << p << ", " << q << ", " << r;
    ++(is_inside ? number_inside : number_outside);
  }
  EXPECT_GT(number_inside, 20);
  EXPECT_GT(number_outside, 20);
}

TEST(Mesh_enclosure, decides_as_brute_force_on_lattices)
{
  compare(meshes::cube(4), 1);
  compare(meshes::voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, 2), 2);
}

TEST(Mesh_enclosure, knows_cavities)
{
  Soup cavity = meshes::cube(1).inverted();
  for(Point& p : cavity.points) p = {p.x() + 1.5, p.y() + 1.5, p.z() + 1.5};
  compare(meshes::cube(4) + cavity, 3);
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
