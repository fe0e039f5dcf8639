// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/domain_test_support.h"
#include "support/exact_surface.h"

#include <CGAL/Volume_filling_curves/internal/domain/Face_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_face_tree {

using namespace domain_test;
using internal::Corners;
using internal::Vector;
using Face_tree = internal::Face_tree<meshes::Kernel>;

// A tilted drum: its ends are fans of slivers, its wall is of strips.
Soup drum()
{
  const std::size_t n = 300;
  Soup soup;
  for(const double z : {0., 1.})
    for(std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * static_cast<double>(i) / n;
      const double x = 8 * std::cos(angle), y = 5 * std::sin(angle);
      soup.points.emplace_back(.8 * x - .6 * y, .36 * x + .48 * y - .8 * z,
                               .48 * x + .64 * y + .6 * z);
    }
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    soup.faces.push_back({i, j, n + j});
    soup.faces.push_back({i, n + j, n + i});
    if(i == 0 || j == 0) continue;
    soup.faces.push_back({0, j, i});
    soup.faces.push_back({n, n + i, n + j});
  }
  return soup;
}

// in the order of the mesh, on which the rounding of slivers depends
std::vector<Corners> corners_of_faces(const Mesh& mesh)
{
  std::vector<Corners> result;
  for(const auto f : mesh.faces()) {
    auto h = mesh.halfedge(f);
    result.emplace_back();
    for(Vector& corner : result.back()) {
      corner = internal::to_vector(mesh.point(mesh.source(h)));
      h = mesh.next(h);
    }
  }
  return result;
}

// to the last bit: no face that matters is left out
TEST(Face_tree, measures_like_all_faces_together)
{
  Random random(8);
  for(const Soup& soup : {drum(), meshes::sphere(2, 3) + meshes::sphere(1, 2).inverted()}) {
    const Face_tree tree(meshes::to_mesh(soup));
    const std::vector<Corners> faces = corners_of_faces(tree.mesh());
    int hits = 0;
    for(int i = 0; i < 500; ++i) {
      const Vector p = internal::to_vector(random_point(random, tree.bbox()));
      const Vector u = random.direction();
      double squared_distance = infinity, along = 3;
      for(const Corners& face : faces) {
        squared_distance = internal::squared_distance_to_triangle(p, face, squared_distance);
        along = (std::min)(along, internal::distance_along_to_triangle(p, u, face));
      }
      ASSERT_EQ(tree.nearest(p).squared_distance, squared_distance);
      ASSERT_EQ(tree.distance_along(p, u, 3), along);
      hits += along < 3;
    }
    EXPECT_GT(hits, 50);
  }
}

// to the last bit, and rays of length 0 stay as they are
TEST(Face_tree, shortens_the_rays_of_a_plane_as_one_by_one)
{
  Random random(10);
  const std::size_t n = 16;
  for(const Soup& soup : {drum(), meshes::sphere(2, 3) + meshes::sphere(1, 2).inverted()}) {
    const Face_tree tree(meshes::to_mesh(soup));
    int hits = 0;
    for(int i = 0; i < 300; ++i) {
      internal::Planar_rays rays;
      rays.source = internal::to_vector(random_point(random, tree.bbox()));
      rays.normal = random.direction();
      const Vector u = rays.normal.unitOrthogonal(), v = rays.normal.cross(u);
      for(std::size_t l = 0; l < n; ++l)
        rays.lengths.push_back(l == 5 ? 0. : 0.2 * static_cast<double>(l % 7));
      for(std::size_t l = 0; l < n; ++l) {
        const double angle = 2 * CGAL_PI * static_cast<double>(l) / n;
        rays.set_direction(l, std::cos(angle) * u + std::sin(angle) * v);
      }
      const std::vector<double> lengths = rays.lengths;
      tree.shorten(rays);
      for(std::size_t l = 0; l < n; ++l) {
        ASSERT_EQ(rays.lengths[l], tree.distance_along(rays.source, rays.direction(l), lengths[l]));
        hits += rays.lengths[l] < lengths[l];
      }
    }
    EXPECT_GT(hits, 100);
  }
}

TEST(Face_tree, knows_the_inside_between_slivers)
{
  const Soup soup = drum();
  const Face_tree tree(meshes::to_mesh(soup));
  const exact_surface::Surface surface(soup);
  Random random(9);
  int inside = 0;
  for(int i = 0; i < 60; ++i) {
    const Point p = random_point(random, tree.bbox());
    ASSERT_EQ(tree.encloses(p), surface.is_inside(p)) << p;
    inside += tree.encloses(p);
  }
  EXPECT_GT(inside, 3);
}

} // namespace test_face_tree
