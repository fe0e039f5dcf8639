// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/mesh_file_test_support.h"

#include <CGAL/Volume_filling_curves/internal/domain/nested_shells.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_shells {

using namespace mesh_file_test;
using CGAL::Volume_filling_curves::internal::Random_source;
using CGAL::Volume_filling_curves::internal::Shell_nesting_search;

using Shells = Mesh_file;

TEST_F(Shells, that_are_cavities_are_known)
{
  const Soup outer = meshes::sphere(2, 2), inner = meshes::sphere(1, 2);
  const Soup island = meshes::sphere(.5, 1), beside = meshes::sphere(1, 1, Point(9, 0, 0));
  const auto accepts = [&](const Soup& soup) { return read(soup); };
  const Soup nest = outer + inner.inverted() + island;
  EXPECT_TRUE(accepts(nest + beside));
  EXPECT_TRUE(defects.empty());
  const double expected = volume();
  EXPECT_TRUE(accepts(beside + nest.inverted()));
  EXPECT_EQ(kinds(), Kinds{"inverted orientation"});
  EXPECT_EQ(defects.size(), 3u) << "the three shells of the nest";
  EXPECT_NEAR(volume(), expected, 1e-12);
  EXPECT_FALSE(accepts(outer + inner + island)) << "two pairs that are turned the same way";
  EXPECT_EQ(kinds(), Kinds{"ambiguous shells"});
  EXPECT_EQ(defects.size(), 2u);
  EXPECT_FALSE(accepts(outer + inner.inverted() + island.inverted()));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].component, 3u);
}

// A cube with a vertex in the middle of each side, and an octahedron between these vertices.
TEST_F(Shells, that_touch_in_all_their_vertices_are_told_apart)
{
  Soup octahedron, cube = meshes::cube(2);
  octahedron.points = {{2, 1, 1}, {0, 1, 1}, {1, 2, 1}, {1, 0, 1}, {1, 1, 2}, {1, 1, 0}};
  octahedron.faces = meshes::sphere(1, 0).faces;
  std::vector<Face> faces;
  for(std::size_t f = 0; f < cube.faces.size(); f += 2) { // of one side
    const Face &s = cube.faces[f], &t = cube.faces[f + 1];
    const std::array<std::size_t, 4> square = {s[0], s[1], s[2], t[2]};
    for(std::size_t k = 0; k < 4; ++k)
      faces.push_back({square[k], square[(k + 1) % 4], cube.points.size()});
    cube.points.push_back(CGAL::midpoint(cube.points[s[0]], cube.points[s[2]]));
  }
  cube.faces = faces;
  EXPECT_TRUE(read(octahedron.inverted() + cube));
  EXPECT_EQ(kinds(), (Kinds{"coincident vertices", "non-manifold vertex"}));
  EXPECT_NEAR(volume(), 8 - 4 / 3., 1e-12);
  EXPECT_FALSE(read(octahedron + cube));
  EXPECT_NE(find("ambiguous shells"), nullptr);
}

// A box of integers, maybe with boxes within, which touch it nowhere and each other in a vertex.
struct Nest
{
  void grow(const std::array<int, 3>& low, int side, Random_source& random)
  {
    Soup box = meshes::cube(side);
    for(Point& p : box.points) p = Point(p.x() + low[0], p.y() + low[1], p.z() + low[2]);
    shells.push_back(box);
    const int half = side / 2 - 1;
    if(half < 2) return;
    for(const int cell : random.index(2) == 0 ? std::array<int, 2>{0, 7} : std::array<int, 2>{1, 6})
      if(random.index(4) > 0)
        grow({low[0] + 1 + half * (cell & 1), low[1] + 1 + half * ((cell & 2) / 2),
              low[2] + 1 + half * ((cell & 4) / 4)},
             half, random);
  }

  std::vector<Soup> shells;
};

// Rays from lattice points meet edges and vertices. Shears keep that so, but not the right angles.
TEST_F(Shells, have_the_places_that_brute_force_finds_at_every_scale)
{
  Random_source random(3);
  std::size_t nested = 0;
  for(const int exponent : {-60, -1, 0, 52, 100, 300})
    for(int shear = 0; shear < 4; ++shear) {
      const double scale = std::ldexp(1., exponent);
      Nest nest;
      nest.grow({0, 0, 0}, 30, random);
      std::vector<exact_surface::Surface> surfaces;
      std::vector<bool> are_outward;
      mesh.clear();
      std::vector<std::vector<vfc::Mesh::Face_index>> faces;
      for(Soup& shell : nest.shells) {
        for(Point& p : shell.points)
          p = Point(scale * (p.x() + shear * p.y()), scale * (p.y() + shear / 2 * p.z()),
                    scale * (p.z() + shear % 2 * p.x()));
        are_outward.push_back(random.index(2) == 0);
        if(!are_outward.back()) shell = shell.inverted();
        surfaces.emplace_back(shell);
        const std::size_t first = mesh.number_of_faces();
        mesh += meshes::to_mesh(shell);
        faces.emplace_back(mesh.faces().begin() + static_cast<std::ptrdiff_t>(first),
                           mesh.faces().end());
      }
      const auto nestings = Shell_nesting_search<vfc::Mesh>::find(mesh, faces);
      for(std::size_t i = 0; i < faces.size(); ++i) {
        const Soup& inner = nest.shells[i];
        const Point middle = CGAL::midpoint(inner.points[0], inner.points[1]);
        Numbers around;
        for(std::size_t j = 0; j < faces.size(); ++j)
          if(j != i && surfaces[j].is_inside(middle)) around.push_back(j);
        EXPECT_EQ(nestings[i].around, around);
        EXPECT_EQ(nestings[i].is_outward, are_outward[i]);
        nested += around.size();
      }
    }
  EXPECT_GT(nested, 200u);
}

TEST_F(Shells, may_be_a_thousand_within_and_above_each_other)
{
  Soup soup;
  for(int k = 0; k < 500; ++k) {
    Soup box = meshes::cube(1002 - 2 * k), above = meshes::cube(1);
    for(Point& p : box.points) p = Point(p.x() + k, p.y() + k, p.z() + k);
    for(Point& p : above.points) p = Point(p.x() + 500, p.y() + 500, p.z() + 2000 + 2 * k);
    soup += (k % 2 == 0 ? box : box.inverted()) + above;
  }
  EXPECT_TRUE(read(soup));
  EXPECT_TRUE(defects.empty());
  double expected = 500;
  for(int k = 0; k < 500; ++k) expected += (k % 2 == 0 ? 1 : -1) * std::pow(1002 - 2 * k, 3);
  EXPECT_NEAR(volume(), expected, 1e-6 * expected);
}

} // namespace test_shells
