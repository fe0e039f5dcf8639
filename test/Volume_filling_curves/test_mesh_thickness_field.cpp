// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "domain_mesh_test_support.h"

#include <CGAL/Volume_filling_curves/IO/vertex_values.h>
#include <CGAL/Volume_filling_curves/Mesh_thickness_field_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace domain_mesh_test;

using Vertex_values = Domain_mesh;

TEST_F(Vertex_values, are_read_from_text_and_ply)
{
  std::vector<double> values;
  EXPECT_TRUE(CGAL::IO::read_vertex_values(
      write("a.csv", "thickness\n# of three\n1\n2.5,\n\n3e-1\n"), 3, values, defects));
  EXPECT_EQ(values, (std::vector<double>{1, 2.5, .3}));
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                             "property double thickness\nproperty float z\nend_header\n";
  EXPECT_TRUE(CGAL::IO::read_vertex_values(write("a.ply", header + "0 .25 1\n1 4 0\n"), 2, values,
                                           defects));
  EXPECT_EQ(values, (std::vector<double>{.25, 4}));
  std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 2\n"
                       "property float thickness\nend_header\n";
  for(const float value : {.5f, 3.f}) {
    std::array<char, sizeof(float)> bytes;
    std::copy_n(reinterpret_cast<const char*>(&value), sizeof(float), bytes.begin());
    binary.append(bytes.data(), bytes.size());
  }
  EXPECT_TRUE(CGAL::IO::read_vertex_values(write("b.ply", binary), 2, values, defects));
  EXPECT_EQ(values, (std::vector<double>{.5, 3}));
  EXPECT_FALSE(
      CGAL::IO::read_vertex_values(write("c.ply", header + "0 .25 1\n"), 2, values, defects));
  EXPECT_EQ(values, (std::vector<double>{.5, 3})) << "as they were";
}

TEST_F(Vertex_values, that_are_bad_are_named_with_their_line)
{
  struct Case
  {
    const char *name, *text;
    Kind kind;
    std::size_t line;
  };
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                             "property double thickness\nend_header\n";
  const std::string minus = header + "0 1\n0 -1\n", word = header + "0 1\n0 one\n",
                    cut = header + "0 1\n";
  for(const Case& c : {
          Case{"a.csv", "1\nx\n", Kind::UNPARSABLE_NUMBER, 2},
          Case{"b.csv", "1\n2 3\n", Kind::UNPARSABLE_NUMBER, 2},
          Case{"c.csv", "r\n1\n0\n", Kind::BAD_VALUE, 3},
          Case{"d.csv", "1\nnan\n", Kind::BAD_VALUE, 2},
          Case{"e.csv", "1\n2\n3\n", Kind::WRONG_VALUE_COUNT, 0},
          Case{"f.csv", "", Kind::WRONG_VALUE_COUNT, 0},
          Case{"g.ply", minus.c_str(), Kind::BAD_VALUE, 8},
          Case{"h.ply", word.c_str(), Kind::UNPARSABLE_NUMBER, 8},
          Case{"i.ply", cut.c_str(), Kind::TRUNCATED_FILE, 8},
          Case{"j.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n",
               Kind::MISSING_PROPERTY, 0},
          Case{"k.ply", "nonsense", Kind::UNREADABLE_FILE, 0},
      }) {
    std::vector<double> values;
    EXPECT_FALSE(CGAL::IO::read_vertex_values(write(c.name, c.text), 2, values, defects)) << c.name;
    ASSERT_FALSE(defects.empty());
    EXPECT_EQ(defects[0].kind, c.kind) << to_string(defects[0], c.name);
    EXPECT_EQ(defects[0].line, c.line) << c.name;
  }
  std::vector<double> values;
  EXPECT_FALSE(CGAL::IO::read_vertex_values("no_such_file.csv", 2, values, defects));
}

TEST(Mesh_thickness_field, interpolates_on_the_surface)
{
  const Mesh mesh = meshes::to_mesh(meshes::voxels({{0, 0, 0}, {1, 0, 0}}));
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
  EXPECT_THROW(Mesh_thickness_field_3<>(mesh, {1, 2}), std::invalid_argument);
  EXPECT_THROW(Mesh_thickness_field_3<>(Mesh(), {}), std::invalid_argument);
}

} // namespace
