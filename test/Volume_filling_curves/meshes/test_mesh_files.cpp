// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/mesh_file_test_support.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

namespace test_mesh_files {

using namespace mesh_file_test;

TEST_F(Mesh_file, reads_a_good_mesh_without_a_word)
{
  EXPECT_TRUE(read(meshes::cube(2)));
  EXPECT_TRUE(defects.empty());
  EXPECT_EQ(mesh.number_of_faces(), 12u);
  EXPECT_NEAR(volume(), 8, 1e-14);
  EXPECT_EQ(origins, (Numbers{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST_F(Mesh_file, reads_all_formats)
{
  const Soup soup = meshes::sphere(1, 2);
  for(const char* name : {"a.off", "b.OBJ", "c.ply", "d.stl"}) {
    const std::string lower = std::string(name) == "b.OBJ" ? "b.obj" : name;
    const std::string path = (m_folder / lower).string();
    ASSERT_TRUE(CGAL::IO::write_polygon_soup(path, soup.points, std::vector<Numbers>([&] {
                                               std::vector<Numbers> polygons;
                                               for(const Face& f : soup.faces)
                                                 polygons.push_back({f.begin(), f.end()});
                                               return polygons;
                                             }()),
                                             CGAL::parameters::stream_precision(17)));
    if(lower != name) fs::rename(path, m_folder / name);
    EXPECT_TRUE(read(name)) << name;
    EXPECT_TRUE(defects.empty()) << defects[0].text;
    EXPECT_EQ(mesh.number_of_vertices(), soup.points.size()) << name;
  }
}

TEST_F(Mesh_file, says_where_a_file_is_malformed)
{
  struct Case
  {
    const char *name, *text;
    const char* kind;
    std::size_t line;
  };
  const std::string good = to_off(meshes::cube());
  for(const Case& c : {
          Case{"empty.off", "", "no geometry", 0},
          Case{"blank.off", " \n\n", "no geometry", 0},
          Case{"word.off", "hello world\n", "unreadable file", 1},
          Case{"zero.off", "OFF\n0 0 0\n", "no geometry", 0},
          Case{"cut.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "truncated file", 6},
          Case{"points.off", "OFF\n# three\n3 2 0\n0 0 0\n1 0 0\n", "truncated file", 5},
          Case{"x.off", "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "unparsable number", 4},
          Case{"nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "non-finite coordinate",
               4},
          Case{"index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "bad index", 6},
          Case{"minus.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "bad index", 6},
          Case{"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2/2 4\n", "bad index", 0},
          Case{"far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n", "bad index", 0},
          Case{"nan.obj", "v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3\n", "unreadable file", 2},
          Case{"word.obj", "v 0 0 0\n\nhello\n", "unreadable file", 3},
          Case{"cut.stl", "solid x\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1\n",
               "no geometry", 0},
          Case{"mesh.txt", "OFF\n", "unknown format", 0},
      }) {
    EXPECT_FALSE(read(c.name, c.text)) << c.name;
    const vfc::Defect* const defect = find(c.kind);
    ASSERT_NE(defect, nullptr) << c.name << ": " << defects.at(0).text;
    EXPECT_EQ(defect->line, c.line) << c.name;
  }
  EXPECT_FALSE(read("minus.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n"));
  EXPECT_NE(defects.at(0).text.find("refers to a vertex before the first"), std::string::npos);
  EXPECT_FALSE(read("plate.wkt", "POLYGON((0 0,1 0,0 1))"));
  EXPECT_NE(defects.at(0).text.find("polygons are no mesh"), std::string::npos);
  EXPECT_FALSE(read("there_is_no_such_file.off"));
  EXPECT_EQ(kinds(), Kinds{"unreadable file"});
}

// Three words are a vertex, wherever lines end; a face ends its line.
TEST_F(Mesh_file, reads_off_files_with_other_lines)
{
  const std::string faces = "3 0 2 1\n3 0 1 3 255 0 0\n3 1 2 3\n3 2 0 3\n";
  for(const std::string& text :
      {"OFF\n4 4 0\n0 0 0  1 0 0\n0 1 0  0 0 1\n" + faces,
       "OFF 4 4 6\r\n0 0 0 1 0 0 0 1 0 0 0 1\r\n" + faces,
       "OFF\n4 4 0\n0\n0 0 1 0\n\n0 0 1 # a comment\n0\n0 0 1 " + faces,
       "OFF\n4 4 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n0 0 1 1 1 1\n" + faces}) {
    EXPECT_TRUE(read("a.off", text)) << text;
    EXPECT_TRUE(defects.empty()) << defects[0].text;
    EXPECT_EQ(mesh.number_of_vertices(), 4u);
    EXPECT_NEAR(volume(), 1. / 6, 1e-14) << text;
  }
}

TEST_F(Mesh_file, says_where_off_files_with_other_lines_are_malformed)
{
  const auto refuse = [&](const std::string& text, const std::string& kind, std::size_t line) {
    EXPECT_FALSE(read("a.off", text)) << text;
    const vfc::Defect* const defect = find(kind);
    ASSERT_NE(defect, nullptr) << text << defects.at(0).text;
    EXPECT_EQ(defect->line, line) << text;
  };
  const std::string head = "OFF\n4 4 0\n0 0 0 1 0 0\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  refuse(head + "0 1 0\n0 0 o\n" + faces, "unparsable number", 5);
  refuse(head + "0 1 0 0 0 nan\n" + faces, "non-finite coordinate", 4);
  refuse(head + "0 1 0 0 0 1\n3 0 2 1\n3 0 1 4\n3 1 2 3\n3 2 0 3\n", "bad index", 6);
  refuse(head + "0 1 0 0 0 1\n3 0 2 1\n4 0 1 3\n3 1 2 3\n3 2 0 3\n", "truncated file", 8);
}

TEST_F(Mesh_file, survives_headers_that_announce_too_much)
{
  EXPECT_FALSE(read("a.off", "OFF\n99999999999999 1 0\n0 0 0\n"));
  EXPECT_FALSE(read("b.off", "OFF\n3 99999999999 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  EXPECT_FALSE(read("c.off", "OFF\n-3 1 0\n0 0 0\n"));
  EXPECT_FALSE(read("d.ply", "ply\nformat ascii 1.0\nelement vertex 99\nend_header\n"));
  EXPECT_FALSE(read("e.off", "OFF\n1999999999\n4 0\n0 0 0\n"));
  EXPECT_FALSE(read("f.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1999999999OFF\n"));
}

// Files of a hundred bytes may request a gigabyte or more for the corners of a face. CGAL's reader
// crashed where a line had no texture, and read beyond it where it had no color.
TEST_F(Mesh_file, normals_colors_and_textures_of_vertices_are_passed_over)
{
  EXPECT_FALSE(read("a.off", "STOFF\n2 0 1\n"));
  EXPECT_FALSE(read("b.off", "STOFF\n4 4 0\n"));
  EXPECT_FALSE(read("c.off", "ST4OFF\n1 0 0\n0 0 0 1\n"));
  EXPECT_FALSE(read("d.off", "STOFF!\n1 0 0\n0 0 0\n"));
  EXPECT_FALSE(read("f.off", "COFF\n4 4 0\nSTOFF\nSTOFF\n"));
  EXPECT_FALSE(read("g.off", "C4OFF\n1 0 0\n0 0 0 1\n"));
  for(const std::string keyword : {"STOFF", "COFF", "NOFF", "CNOFF", "STCNOFF"}) {
    EXPECT_TRUE(read("e.off", keyword + "\n4 4 0\n0 0 0 9 9\n1 0 0\n0 1 0 .5 .5 .5\n0 0 1 7\n"
                                        "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"))
        << keyword;
    EXPECT_NEAR(volume(), 1 / 6., 1e-15);
  }
}

TEST_F(Mesh_file, divides_by_the_fourth_coordinate)
{
  EXPECT_TRUE(read("a.off", "4OFF\n4 4 0\n0 0 0 1\n2 0 0 2\n0 .5 0 .5\n0 0 1 1\n"
                            "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"));
  EXPECT_NEAR(volume(), 1 / 6., 1e-15);
  EXPECT_FALSE(read("b.off", "4OFF\n3 1 0\n0 0 0 1\n1 0 0 0\n0 1 0 1\n3 0 1 2\n"));
  ASSERT_EQ(kinds(), Kinds{"non-finite coordinate"});
  EXPECT_EQ(defects[0].line, 4u);
}

TEST_F(Mesh_file, refuses_faces_with_more_corners_than_the_file_can_hold)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string ply = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                          "element face 1\nproperty list uint int vertex_indices\nend_header\n";
  EXPECT_FALSE(read("a.off", "OFF\n4 1 0\n" + points + "1000000000 0 1 2\n"));
  ASSERT_EQ(kinds(), Kinds{"bad index"});
  EXPECT_EQ(defects[0].line, 7u);
  EXPECT_FALSE(read("b.ply", "ply\nformat ascii 1.0\n" + ply + points + "1000000000 0 1 2\n"));
  EXPECT_EQ(kinds(), Kinds{"bad index"});
  EXPECT_FALSE(read("c.ply", "ply\nformat ascii 1.0\n" + ply + points + "-1 0 1 2\n"));
  EXPECT_EQ(kinds(), Kinds{"bad index"});
  EXPECT_FALSE(read("d.ply", "ply\nformat binary_little_endian 1.0\n" + ply +
                                 std::string(48, '\0') + "\x01\x02\x03\x74"));
  EXPECT_EQ(kinds(), Kinds{"bad index"});
}

// Numbers of four bytes, the highest first.
std::string big_endian(std::initializer_list<std::uint32_t> numbers)
{
  std::string bytes;
  for(const std::uint32_t number : numbers)
    for(const unsigned shift : {24u, 16u, 8u, 0u}) bytes += static_cast<char>(number >> shift);
  return bytes;
}

std::string binary_off(std::uint32_t corners_of_last_face)
{
  const std::uint32_t one = 0x3f800000; // as a float
  return "OFF BINARY\n" + big_endian({4, 4, 0, 0, 0, 0, one, 0, 0, 0, one, 0, 0, 0, one}) +
         big_endian({3, 0, 2, 1, 0, 3, 0, 1, 3, 3, one, one, one, 3, 1, 2, 3, 0}) +
         big_endian({corners_of_last_face, 2, 0, 3, 0});
}

TEST_F(Mesh_file, reads_binary_off_files)
{
  EXPECT_TRUE(read("a.off", binary_off(3)));
  EXPECT_TRUE(defects.empty());
  EXPECT_NEAR(volume(), 1 / 6., 1e-15);
  EXPECT_FALSE(read("b.off", binary_off(1000000000)));
  EXPECT_EQ(kinds(), Kinds{"bad index"});
  for(const std::size_t size : {12u, 30u, 100u, 160u}) {
    EXPECT_FALSE(read("c.off", binary_off(3).substr(0, size))) << size;
    EXPECT_EQ(kinds(), Kinds{"truncated file"}) << size;
  }
  EXPECT_FALSE(read("d.off", "OFF BINARY\n" + big_endian({4000000000, 4000000000, 0})));
  EXPECT_EQ(kinds(), Kinds{"truncated file"});
}

TEST_F(Mesh_file, continues_lines_of_obj_files)
{
  EXPECT_TRUE(read("a.obj", "v 0 0 0\nv 1 0 \\\n 0\nv 0 1 0\nv 0 0 1\n"
                            "f 1 3 \\\r\n2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
  EXPECT_NEAR(volume(), 1 / 6., 1e-15);
  EXPECT_FALSE(read("b.obj", "v 0 0 \\\n0\nhello\n"));
  ASSERT_EQ(kinds(), Kinds{"unreadable file"});
  EXPECT_EQ(defects[0].line, 3u) << "lines are counted as they are";
  for(const std::string nothing : {"\\", "\\\\", "\\ \n", "\\\n\\\n", "v 0 0 0\n\\\t"})
    EXPECT_FALSE(read("c.obj", nothing)) << nothing;
}

TEST_F(Mesh_file, says_what_of_a_ply_file_is_missing)
{
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nend_header\n";
  EXPECT_FALSE(read("a.ply", header + "0 0 0\n1 0 0\n0"));
  ASSERT_EQ(kinds(), Kinds{"truncated file"});
  EXPECT_EQ(defects[0].line, 10u);
  EXPECT_NE(defects[0].message.find("vertex 3 of 3"), std::string::npos);
}

// Every bit of a coordinate arrives, whatever the format.
TEST_F(Mesh_file, reads_the_nearest_doubles)
{
  Soup soup = meshes::sphere(1 / 3., 1, Point(.1, .2, .3));
  soup.points[0] = Point(1.1, 5e-324, 1e-310);
  std::vector<Numbers> polygons;
  for(const Face& f : soup.faces) polygons.push_back({f.begin(), f.end()});
  for(const char* name : {"a.off", "b.obj", "c.ply"}) {
    const std::string path = (m_folder / name).string();
    ASSERT_TRUE(CGAL::IO::write_polygon_soup(
        path, soup.points, polygons,
        CGAL::parameters::stream_precision(17).use_binary_mode(false)));
    EXPECT_TRUE(read(name)) << name;
    ASSERT_EQ(mesh.number_of_vertices(), soup.points.size());
    for(const auto v : mesh.vertices()) EXPECT_EQ(mesh.point(v), soup.points[v]) << name;
  }
}

// Expectations of the shared data's manifest for every mesh.
TEST(Shared_domains, get_what_their_manifest_says)
{
  const fs::path folder = VFC_SHARED_DATA;
  std::ifstream manifest(folder / "MANIFEST_domains.csv");
  if(!manifest) GTEST_SKIP() << "there is no shared data in " << folder.string();
  std::string line;
  std::getline(manifest, line);
  int files = 0;
  for(; std::getline(manifest, line); ++files) {
    const std::string file = line.substr(0, line.find(','));
    const auto [mesh, origins, vertices, unmended, defects, is_accepted] =
        vfc::read_mesh_and_defects((folder / file).string());
    const auto says = [&](const char* text) { return line.find(text) != std::string::npos; };
    EXPECT_EQ(is_accepted, !says(",reject")) << file;
    const bool is_silent = says(",accept,") || says("accept (the cavity is outside)");
    EXPECT_EQ(defects.empty(), is_silent) << file;
    if(says("message about the boundary")) {
      EXPECT_NE(defects.back().message.find("boundary"), std::string::npos);
    }
    if(says("with a warning")) {
      ASSERT_EQ(defects.size(), 1u) << file;
      EXPECT_FALSE(defects[0].is_error);
    }
  }
  EXPECT_GT(files, 15);
}

} // namespace test_mesh_files
