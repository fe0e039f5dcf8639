// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/Mesh_thickness_field_3.h>

#include <gtest/gtest.h>

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

} // namespace test_mesh_thickness_field
