// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/Mesh_fields_3.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_mesh_thickness_field {

using namespace CGAL::Volume_filling_curves;
using meshes::Mesh;

TEST(Mesh_thickness_field, interpolates_on_the_surface)
{
  Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}, {1, 0, 0}}));
  std::vector<double> values;
  for(const auto v : mesh.vertices())
    values.push_back(1 + mesh.point(v).x() + 2 * mesh.point(v).y() + 4 * mesh.point(v).z());
  const Mesh_thickness_field_3<> field(mesh, values);
  // a linear function is reproduced wherever the closest point is known
  EXPECT_NEAR(field({.3, .4, .1}), 1 + .3 + .8, 1e-15) << "the bottom is closest";
  EXPECT_NEAR(field({1.4, .3, .9}), 1 + 1.4 + .6 + 4, 1e-15) << "the top is closest";
  EXPECT_NEAR(field({-1, -1, -1}), 1, 1e-15) << "a corner";
  EXPECT_NEAR(field({1.25, -1, 3}), 1 + 1.25 + 4, 1e-15) << "a side";
  EXPECT_NEAR(field({2, 1, 1}), 9, 1e-15);
  const auto map = mesh.add_property_map<Mesh::Vertex_index, double>("v:thickness").first;
  for(const auto v : mesh.vertices()) map[v] = values[v];
  EXPECT_EQ(Mesh_thickness_field_3<>(mesh, map)({.3, .4, .1}), field({.3, .4, .1}));
  EXPECT_THROW(Mesh_thickness_field_3<>(mesh, {1, 2}), std::invalid_argument);
  EXPECT_THROW(Mesh_thickness_field_3<>(Mesh(), {}), std::invalid_argument);
}

// Faces that are not connected crashed the shells of the mesh.
TEST(Mesh_thickness_field, takes_meshes_that_are_not_closed)
{
  const meshes::Soup cube = meshes::voxels({{0, 0, 0}});
  Mesh apart;
  std::vector<double> values;
  for(const meshes::Face& f : cube.faces) {
    std::vector<Mesh::Vertex_index> corners;
    for(const std::size_t v : f) {
      corners.push_back(apart.add_vertex(cube.points[v]));
      values.push_back(1 + cube.points[v].x());
    }
    apart.add_face(corners);
  }
  EXPECT_NEAR(Mesh_thickness_field_3<>(apart, values)({.3, .4, .1}), 1.3, 1e-15);
  Mesh open = meshes::to_mesh(cube);
  CGAL::Euler::remove_face(open.halfedge(*open.faces().begin()), open);
  open.collect_garbage();
  EXPECT_EQ(Mesh_thickness_field_3<>(open, std::vector<double>(8, 2.))({.3, .4, .1}), 2);
}

TEST(Mesh_thickness_field, takes_no_value_of_a_vertex_without_faces)
{
  Mesh mesh;
  mesh.add_vertex({9, 9, 9});
  std::vector<double> values = {100};
  for(const auto& p : meshes::voxels({{0, 0, 0}}).points) {
    mesh.add_vertex(p);
    values.push_back(1 + p.x());
  }
  for(const meshes::Face& f : meshes::voxels({{0, 0, 0}}).faces)
    mesh.add_face(Mesh::Vertex_index(static_cast<unsigned>(f[0] + 1)),
                  Mesh::Vertex_index(static_cast<unsigned>(f[1] + 1)),
                  Mesh::Vertex_index(static_cast<unsigned>(f[2] + 1)));
  EXPECT_NEAR(Mesh_thickness_field_3<>(mesh, values)({.3, .4, .1}), 1.3, 1e-15);
}

TEST(Mesh_thickness_field, refuses_coordinates_that_are_invalid_or_too_large)
{
  const std::vector<double> values(8, 1.);
  for(const double x : {std::numeric_limits<double>::quiet_NaN(), 1e200}) {
    Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}}));
    mesh.point(Mesh::Vertex_index(3)) = {x, 0, 0};
    EXPECT_THROW(Mesh_thickness_field_3<>(mesh, values), std::invalid_argument) << x;
  }
}

TEST(Mesh_thickness_field, becomes_a_function_that_can_be_copied)
{
  std::function<double(const Mesh::Point&)> function;
  {
    const Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}}));
    const Mesh_thickness_field_3<> field(mesh, std::vector<double>(8, 2.));
    function = field;
  }
  EXPECT_EQ(function({.3, .4, .1}), 2);
}

// They have no nearest face, which crashed.
TEST(Mesh_thickness_field, refuses_points_that_are_invalid_or_too_far)
{
  const Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}}));
  const Mesh_thickness_field_3<> field(mesh, std::vector<double>(8, 2.));
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double x : {std::numeric_limits<double>::quiet_NaN(), -infinity, 2e150, 1e200})
    EXPECT_THROW(field({0, x, 0}), std::invalid_argument) << x;
  EXPECT_EQ(field({1e150, -1e150, 1e150}), 2);
}

} // namespace test_mesh_thickness_field
