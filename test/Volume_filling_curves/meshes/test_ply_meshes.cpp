// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/mesh_file_test_support.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace test_ply_meshes {

using mesh_file_test::Mesh_file;

const std::string start = "ply\nformat ascii 1.0\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string vertices = "element vertex 4\n" + xyz;
const std::string faces = "element face 4\nproperty list uchar int vertex_indices\n";
const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string corners = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

class Ply_mesh : public Mesh_file
{
protected:
  void accepts(const std::string& text)
  {
    EXPECT_TRUE(read("a.ply", text)) << text << defects[0].text;
    EXPECT_NEAR(volume(), 1. / 6, 1e-14) << text;
  }

  void refuses(const std::string& text,
               const std::string& kind,
               const std::string& message,
               std::size_t line)
  {
    EXPECT_FALSE(read("a.ply", text)) << text;
    ASSERT_FALSE(defects.empty());
    EXPECT_EQ(defects[0].kind, kind) << text;
    EXPECT_EQ(defects[0].message, message) << text;
    EXPECT_EQ(defects[0].line, line) << text;
  }
};

// CGAL 5.5's reader crashes on each of them.
TEST_F(Ply_mesh, with_a_header_that_makes_no_sense_is_refused_with_its_line)
{
  refuses(start + "property float x\nend_header\n", "unknown format",
          "a property comes before any element", 3);
  refuses(start + "elment vertex 4\n" + xyz + "end_header\n" + points, "unknown format",
          "'elment' does not belong in the header", 3);
  refuses(start + "element vertex 3\nproperty list uchar int x\nproperty list uchar int y\n"
                  "property float z\nelement face 1\nproperty float vertex_indices\nend_header\n"
                  "1 0 1 0 0\n1 1 1 0 0\n1 0 1 1 0\n3\n",
          "missing coordinates", "vertices have no numbers x, y and z", 3);
  refuses(start + vertices + "element face 1\nproperty float vertex_indices\nend_header\n" +
              points + "3\n",
          "unknown format", "faces have no list vertex_indices", 7);
}

TEST_F(Ply_mesh, with_a_header_that_is_ambiguous_is_refused)
{
  refuses("nonsense", "unknown format", "the first word is not ply", 1);
  refuses("ply\nformat utf8 1.0\n", "unknown format", "'utf8' is no format of PLY", 2);
  refuses(start + vertices, "truncated file", "the header has no end_header", 7);
  refuses(start + vertices + vertices + faces + "end_header\n" + points + points + corners,
          "unknown format", "element vertex comes twice", 7);
  refuses(start + "element vertex -4\n" + xyz + "end_header\n", "unparsable number",
          "'-4' is not a number of items", 3);
  refuses("ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty real x\nend_header\n",
          "unknown format", "'real' is no type of a property", 4);
}

TEST_F(Ply_mesh, tells_which_index_is_wrong_as_the_file_has_it)
{
  const std::string head = start + vertices + faces + "end_header\n" + points;
  refuses(head + "3 0 2 1\n3 0 -2 3\n3 1 2 3\n3 2 0 3\n", "bad index",
          "there is no vertex -2 (numbered from 0)", 15);
  refuses(head + "3 0 2 1\n3 0 1 3\n3 1 2 4\n3 2 0 3\n", "bad index",
          "there is no vertex 4 (numbered from 0)", 16);
  refuses(head + "3 0 2 1.5\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "bad index",
          "there is no vertex 1.5 (numbered from 0)", 14);
  refuses(head + "3 0 2 1\n3 0 12345678 3\n3 1 2 3\n3 2 0 3\n", "bad index",
          "there is no vertex 12345678 (numbered from 0)", 15);
  refuses(start + vertices + faces + "end_header\n0 0 0\n1 0 zero\n0 1 0\n0 0 1\n" + corners,
          "unparsable number", "'zero' is not a number", 11);
}

TEST_F(Ply_mesh, may_have_whatever_types_and_elements_besides)
{
  accepts(start + vertices + faces + "end_header\n" + points + corners);
  accepts(start + faces + vertices + "end_header\n" + corners + points);
  accepts(start + "comment property first\n\n" + vertices + faces + "element other 2\n" +
          "property list int double values\nproperty uchar n\nend_header\n" + points + corners +
          "2 1e9 1 7\n0 8\n");
  accepts(start + "element vertex 4\nproperty int x\nproperty uint8 y\nproperty float64 z\n" +
          "element face 4\nproperty uchar red\nproperty list uint8 uint16 vertex_index\n" +
          "end_header\n" + points + "9 3 0 2 1\n9 3 0 1 3\n9 3 1 2 3\n9 3 2 0 3\n");
}

TEST_F(Ply_mesh, may_consist_of_strips)
{
  const std::string strips = "property list int int vertex_indices\nend_header\n" + points;
  accepts(start + vertices + "element tristrips 1\n" + strips + "6 0 2 1 3 0 2\n");
  accepts(start + vertices + "element face 0\nproperty list uchar int vertex_indices\n" +
          "element tristrips 1\n" + strips + "9 0 2 1 -1 0 1 3 2 0\n");
  accepts(start + vertices + "element tristrips 3\n" + strips +
          "5 0 2 1 3 -1\n6 -1 -1 3 3 3 0\n6 1 3 0 3 2 2\n");
  refuses(start + vertices + "element tristrips 1\n" + strips + "5 0 2 1 3 4\n", "bad index",
          "there is no vertex 4 (numbered from 0)", 14);
  refuses(start + vertices + "element tristrips 1\n" + strips + "5 0 2 1 -2 3\n", "bad index",
          "there is no vertex -2 (numbered from 0)", 14);
}

// Numbers of type float have the values that a binary file could store.
TEST_F(Ply_mesh, rounds_coordinates_to_their_type)
{
  const std::string text = "0.1 0 0\n1 0 0\n0 1 0\n0 0 1\n" + corners;
  ASSERT_TRUE(read("a.ply", start + vertices + faces + "end_header\n" + text));
  EXPECT_EQ(mesh.points().begin()->x(), static_cast<double>(.1f));
}

} // namespace test_ply_meshes
