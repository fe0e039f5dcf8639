// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/vertex_fields.h"
#include "support/repair_test_support.h"

#include <CGAL/Volume_filling_curves/Mesh_fields_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

// Values at the vertices of a file when the mesh in it was mended.
namespace test_values_of_mended_meshes {

using namespace repair_test;
using Thickness_field = CGAL::Volume_filling_curves::Mesh_thickness_field_3<>;
using Direction_field = CGAL::Volume_filling_curves::Mesh_direction_field_3<>;

double value_at(const Point& p)
{
  return 1 + p.x() + 2 * p.y() + 4 * p.z();
}

class Values_of_mended_mesh : public Repair
{
protected:
  // expects a linear function to be the same at the vertices of the mended mesh
  void expect_kept(const Soup& soup, double tolerance)
  {
    mend(soup);
    vfc::Mesh_and_defects mended;
    mended.mesh = mesh;
    mended.unmended = std::make_shared<const vfc::Mesh_soup>(faces_of(soup));
    std::vector<double> values;
    std::vector<std::array<double, 3>> vectors;
    for(const Point& p : soup.points) {
      values.push_back(value_at(p));
      vectors.push_back({0, value_at(p), 0});
    }
    const auto numbers = vfc::values_at_vertices<Thickness_field>(mended, values);
    const auto directions = vfc::values_at_vertices<Direction_field>(mended, vectors);
    ASSERT_EQ(numbers.size(), mesh.number_of_vertices());
    ASSERT_EQ(directions.size(), mesh.number_of_vertices());
    std::size_t i = 0;
    for(const Point& p : mesh.points()) {
      EXPECT_NEAR(numbers[i], value_at(p), tolerance);
      EXPECT_NEAR(directions[i][1], value_at(p), tolerance);
      EXPECT_EQ(directions[i++][0], 0);
    }
  }
};

TEST_F(Values_of_mended_mesh, are_those_of_the_file_where_a_hole_is_closed)
{
  Soup open = meshes::voxels({{0, 0, 0}, {1, 0, 0}});
  open.faces.erase(open.faces.begin(), open.faces.begin() + 2);
  open.points.emplace_back(9, 9, 9); // of no face
  expect_kept(open, 1e-14);
}

// Faces apart crashed the field, and those without an area have no point that is nearest.
TEST_F(Values_of_mended_mesh, are_those_of_the_file_where_faces_are_joined)
{
  const Soup cube = meshes::voxels({{0, 0, 0}});
  Soup apart;
  for(const Face& f : cube.faces) {
    const std::size_t n = apart.points.size();
    const double gap = 1e-8 * static_cast<double>(n);
    for(const std::size_t v : f)
      apart.points.push_back(cube.points[v] + meshes::Kernel::Vector_3(gap, 0, 0));
    apart.faces.push_back({n, n + 1, n + 2});
  }
  apart.faces.push_back({0, 0, 1});
  expect_kept(apart, 1e-5);
}

TEST_F(Values_of_mended_mesh, are_those_of_the_nearest_point_on_new_vertices)
{
  Soup shells = meshes::voxels({{0, 0, 0}});
  for(const Point& p : Soup(shells).points)
    shells.points.emplace_back(p.x() + 0.5, p.y() + 0.25, p.z() + 0.125);
  for(const Face& f : std::vector<Face>(shells.faces))
    shells.faces.push_back({f[0] + 8, f[1] + 8, f[2] + 8});
  expect_kept(shells, 1e-14); // their union has vertices where faces meet
}

} // namespace test_values_of_mended_meshes
