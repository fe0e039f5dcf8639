// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/Mesh_fields_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace test_mesh_direction_field {

using namespace CGAL::Volume_filling_curves;
using meshes::Mesh;
using Direction = std::array<double, 3>;

void expect_parallel(const Direction& a, const Direction& b)
{
  EXPECT_NEAR(a[0] * b[1], a[1] * b[0], 1e-15);
  EXPECT_NEAR(a[1] * b[2], a[2] * b[1], 1e-15);
  EXPECT_NEAR(a[2] * b[0], a[0] * b[2], 1e-15);
}

TEST(Mesh_direction_field, interpolates_on_the_surface_whatever_the_signs)
{
  const Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}, {1, 0, 0}}));
  std::vector<Direction> vectors, turned;
  for(const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const double sign = v.idx() % 2 == 0 ? 1 : -1;
    vectors.push_back({1, p.x(), 0});
    turned.push_back({sign, sign * p.x(), 0});
  }
  const Mesh_direction_field_3<> field(mesh, vectors), same(mesh, turned);
  for(const Mesh::Point& p : {Mesh::Point(.3, .4, .1), Mesh::Point(1.4, .3, .9)}) {
    expect_parallel(field(p), {1, p.x(), 0});
    expect_parallel(same(p), {1, p.x(), 0});
  }
}

// Squares of such lengths underflow or overflow.
TEST(Mesh_direction_field, ignores_the_signs_of_vectors_of_any_length)
{
  const Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}}));
  for(const double length : {1e-300, 1e-170, 1e170, 1e300}) {
    std::vector<Direction> vectors;
    for(const auto v : mesh.vertices())
      vectors.push_back(
          {v.idx() % 2 == 0 ? length : -length, length * (v.idx() % 2 == 0 ? -2 : 2), 0});
    const Mesh_direction_field_3<> field(mesh, vectors);
    for(const Mesh::Point& p : {Mesh::Point(.3, .4, .1), Mesh::Point(.6, .3, .9)}) {
      const Direction direction = field(p);
      EXPECT_NEAR(std::abs(direction[0]) / length, 1, 1e-15) << length;
      EXPECT_NEAR(direction[1] / direction[0], -2, 1e-15) << length;
    }
  }
}

TEST(Mesh_direction_field, may_have_vertices_without_a_direction)
{
  const Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}}));
  std::vector<Direction> vectors(mesh.number_of_vertices(), Direction{0, 0, 0});
  EXPECT_EQ(Mesh_direction_field_3<>(mesh, vectors)({.5, .5, .5}), (Direction{0, 0, 0}));
  for(Direction& vector : vectors) vector = {0, 0, 2};
  expect_parallel(Mesh_direction_field_3<>(mesh, vectors)({.5, .5, .5}), {0, 0, 1});
}

TEST(Mesh_direction_field, needs_a_vector_per_vertex)
{
  const Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}}));
  const std::vector<Direction> one(1);
  EXPECT_THROW(Mesh_direction_field_3<>(mesh, one), std::invalid_argument);
  EXPECT_THROW(Mesh_direction_field_3<>(Mesh(), std::vector<Direction>()), std::invalid_argument);
}

static_assert(
    std::is_convertible_v<Mesh_direction_field_3<>, std::function<Direction(const Mesh::Point&)>>);

TEST(Mesh_direction_field, refuses_points_that_are_invalid_or_too_far)
{
  const Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}}));
  const Mesh_direction_field_3<> field(mesh, std::vector<Direction>(8, {0, 0, 2}));
  for(const double x : {std::nan(""), 1e200})
    EXPECT_THROW(field({0, x, 0}), std::invalid_argument) << x;
}

} // namespace test_mesh_direction_field
