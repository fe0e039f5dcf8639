// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "domain_mesh_test_support.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace domain_mesh_test;

TEST_F(Domain_mesh, reads_a_good_mesh_without_a_word)
{
  EXPECT_TRUE(read(meshes::cube(2)));
  EXPECT_TRUE(defects.empty());
  EXPECT_EQ(mesh.number_of_faces(), 12u);
  EXPECT_NEAR(volume(), 8, 1e-14);
  EXPECT_EQ(origins, (Numbers{0, 1, 2, 3, 4, 5, 6, 7}));
  CGAL::Polyhedron_3<meshes::Kernel> polyhedron;
  EXPECT_TRUE(CGAL::IO::read_domain_mesh((m_folder / "soup.off").string(), polyhedron, defects));
  EXPECT_EQ(polyhedron.size_of_vertices(), 8u);
}

TEST_F(Domain_mesh, reads_all_formats)
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
    EXPECT_TRUE(CGAL::IO::read_domain_mesh((m_folder / name).string(), mesh, defects)) << name;
    EXPECT_TRUE(defects.empty()) << name << ": " << to_string(defects[0], name);
    EXPECT_EQ(mesh.number_of_vertices(), soup.points.size()) << name;
  }
}

TEST_F(Domain_mesh, does_not_touch_the_mesh_if_there_is_an_error)
{
  ASSERT_TRUE(read(meshes::cube()));
  EXPECT_FALSE(read("bad.off", "nonsense"));
  EXPECT_EQ(mesh.number_of_faces(), 12u);
}

TEST_F(Domain_mesh, says_where_a_file_is_malformed)
{
  struct Case
  {
    const char *name, *text;
    Kind kind;
    std::size_t line;
  };
  const std::string good = to_off(meshes::cube());
  for(const Case& c : {
          Case{"empty.off", "", Kind::NO_GEOMETRY, 0},
          Case{"blank.off", " \n\n", Kind::NO_GEOMETRY, 0},
          Case{"word.off", "hello world\n", Kind::UNREADABLE_FILE, 0},
          Case{"zero.off", "OFF\n0 0 0\n", Kind::NO_GEOMETRY, 0},
          Case{"cut.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Kind::TRUNCATED_FILE, 7},
          Case{"points.off", "OFF\n# three\n3 2 0\n0 0 0\n1 0 0\n", Kind::TRUNCATED_FILE, 6},
          Case{"x.off", "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", Kind::UNPARSABLE_NUMBER, 4},
          Case{"nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n",
               Kind::NON_FINITE_COORDINATE, 4},
          Case{"index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", Kind::BAD_INDEX, 6},
          Case{"minus.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", Kind::BAD_INDEX, 6},
          Case{"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2/2 4\n", Kind::BAD_INDEX, 4},
          Case{"nan.obj", "v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3\n", Kind::NON_FINITE_COORDINATE, 2},
          Case{"cut.stl", "solid x\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1\n",
               Kind::NO_GEOMETRY, 0},
          Case{"mesh.txt", "OFF\n", Kind::UNKNOWN_FORMAT, 0},
      }) {
    EXPECT_FALSE(read(c.name, c.text)) << c.name;
    const Mesh_defect* const defect = find(c.kind);
    ASSERT_NE(defect, nullptr) << c.name << ": " << to_string(defects.at(0), "");
    EXPECT_EQ(defect->line, c.line) << c.name;
  }
  EXPECT_FALSE(CGAL::IO::read_domain_mesh("there_is_no_such_file.off", mesh, defects));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::UNREADABLE_FILE});
}

TEST_F(Domain_mesh, survives_headers_that_announce_too_much)
{
  EXPECT_FALSE(read("a.off", "OFF\n99999999999999 1 0\n0 0 0\n"));
  EXPECT_FALSE(read("b.off", "OFF\n3 99999999999 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  EXPECT_FALSE(read("c.off", "OFF\n-3 1 0\n0 0 0\n"));
  EXPECT_FALSE(read("d.ply", "ply\nformat ascii 1.0\nelement vertex 99\nend_header\n"));
}

// What the manifest of the shared data expects of every mesh.
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
    Mesh mesh;
    std::vector<Mesh_defect> defects;
    const bool is_accepted = CGAL::IO::read_domain_mesh((folder / file).string(), mesh, defects);
    const auto says = [&](const char* text) { return line.find(text) != std::string::npos; };
    EXPECT_EQ(is_accepted, !says(",reject")) << file;
    const bool is_silent = says(",accept,") || says("accept (the cavity is outside)");
    EXPECT_EQ(defects.empty(), is_silent) << file;
    if(says("message about the boundary")) {
      EXPECT_NE(defects.back().message.find("boundary"), std::string::npos);
    }
    if(says("with a warning")) {
      ASSERT_EQ(defects.size(), 1u) << file;
      EXPECT_FALSE(is_error(defects[0].kind));
    }
  }
  EXPECT_GT(files, 15);
}

} // namespace
