// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "exact_brute_force.h"
#include "mesh_test_support.h"

#include <CGAL/Volume_filling_curves/IO/domain_mesh.h>
#include <CGAL/Volume_filling_curves/IO/vertex_values.h>
#include <CGAL/Volume_filling_curves/Mesh_thickness_field_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Volume_filling_curves;
namespace fs = std::filesystem;

using Kind = Mesh_defect_kind;
using meshes::Face;
using meshes::Mesh;
using meshes::Point;
using meshes::Soup;
using Numbers = std::vector<std::size_t>;

class Domain_mesh : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
    m_folder = fs::temp_directory_path() / ("vfc_domain_mesh_" + std::string(info->name()));
    fs::create_directories(m_folder);
  }

  void TearDown() override { fs::remove_all(m_folder); }

  std::string write(const std::string& name, const std::string& text) const
  {
    const std::string path = (m_folder / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  // reads what `text` says into `mesh` and lists its defects
  bool read(const std::string& name, const std::string& text)
  {
    return CGAL::IO::read_domain_mesh(write(name, text), mesh, defects, origins);
  }

  bool read(const Soup& soup) { return read("soup.off", to_off(soup)); }

  static std::string to_off(const Soup& soup)
  {
    std::ostringstream out;
    out.precision(17);
    out << "OFF\n" << soup.points.size() << " " << soup.faces.size() << " 0\n";
    for(const Point& p : soup.points) out << p << "\n";
    for(const Face& f : soup.faces) out << "3 " << f[0] << " " << f[1] << " " << f[2] << "\n";
    return out.str();
  }

  const Mesh_defect* find(Kind kind) const
  {
    const auto found = std::find_if(defects.begin(), defects.end(),
                                    [&](const Mesh_defect& d) { return d.kind == kind; });
    return found == defects.end() ? nullptr : &*found;
  }

  // the kinds of all defects, each once
  std::vector<Kind> kinds() const
  {
    std::vector<Kind> result;
    for(const Mesh_defect& d : defects)
      if(std::find(result.begin(), result.end(), d.kind) == result.end()) result.push_back(d.kind);
    return result;
  }

  double volume() const { return CGAL::Polygon_mesh_processing::volume(mesh); }

  fs::path m_folder;
  Mesh mesh;
  std::vector<Mesh_defect> defects;
  Numbers origins;
};

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

TEST_F(Domain_mesh, lists_every_hole)
{
  Soup soup = meshes::sphere(1, 2);
  soup.faces.erase(soup.faces.begin() + 100);
  soup.faces.erase(soup.faces.begin());
  EXPECT_FALSE(read(soup));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::OPEN_BOUNDARY});
  ASSERT_EQ(defects.size(), 2u);
  EXPECT_EQ(defects[0].vertices.size(), 3u);
  EXPECT_NE(defects[0].message.find("boundary of 3 edges"), std::string::npos);
}

TEST_F(Domain_mesh, lists_degenerate_and_duplicate_faces)
{
  Soup soup = meshes::cube();
  soup.faces.push_back({0, 0, 1});
  soup.faces.push_back(soup.faces[3]);
  soup.points.push_back(CGAL::midpoint(soup.points[0], soup.points[1]));
  soup.faces.push_back({0, 8, 1});
  EXPECT_FALSE(read(soup));
  const Mesh_defect* const degenerate = find(Kind::DEGENERATE_FACE);
  ASSERT_NE(degenerate, nullptr);
  EXPECT_EQ(degenerate->faces, Numbers{13});
  EXPECT_EQ(std::count_if(defects.begin(), defects.end(),
                          [](const Mesh_defect& d) { return d.kind == Kind::DEGENERATE_FACE; }),
            2);
  const Mesh_defect* const duplicate = find(Kind::DUPLICATE_FACE);
  ASSERT_NE(duplicate, nullptr);
  EXPECT_EQ(duplicate->faces, (Numbers{4, 14}));
  EXPECT_NE(find(Kind::NON_MANIFOLD_EDGE), nullptr);
}

TEST_F(Domain_mesh, refuses_an_edge_of_four_faces)
{
  EXPECT_FALSE(read(meshes::voxels({{0, 0, 0}, {1, 1, 0}})));
  ASSERT_EQ(kinds(), std::vector<Kind>{Kind::NON_MANIFOLD_EDGE});
  EXPECT_EQ(defects[0].faces.size(), 4u);
  EXPECT_EQ(defects[0].vertices.size(), 2u);
}

TEST_F(Domain_mesh, splits_a_vertex_where_two_cubes_touch)
{
  EXPECT_TRUE(read(meshes::voxels({{0, 0, 0}, {1, 1, 1}})));
  ASSERT_EQ(kinds(), std::vector<Kind>{Kind::NON_MANIFOLD_VERTEX});
  EXPECT_EQ(mesh.number_of_vertices(), 16u);
  EXPECT_NEAR(volume(), 2, 1e-14);
  EXPECT_EQ(origins.size(), 16u);
  EXPECT_EQ(origins.back() + 1, defects[0].vertices.at(0));
  const Triangle_mesh_domain_3<> domain(mesh);
  EXPECT_FALSE(domain.is_triangle_inside({.5, .5, .5}, {1.5, 1.5, 1.5}, {.5, .5, .5}));
}

TEST_F(Domain_mesh, merges_vertices_and_leaves_out_unused_ones)
{
  Soup soup = meshes::cube();
  soup.points.push_back(soup.points[0]);
  soup.points.insert(soup.points.begin() + 3, Point(5, 5, 5));
  for(Face& f : soup.faces)
    for(std::size_t& v : f) v += v >= 3;
  for(std::size_t& v : soup.faces[0])
    if(v == 0) v = 9;
  EXPECT_TRUE(read(soup));
  EXPECT_EQ(kinds(), (std::vector<Kind>{Kind::COINCIDENT_VERTICES, Kind::ISOLATED_VERTEX}));
  EXPECT_EQ(find(Kind::COINCIDENT_VERTICES)->vertices, Numbers{10});
  EXPECT_EQ(find(Kind::ISOLATED_VERTEX)->vertices, Numbers{4});
  EXPECT_EQ(origins, (Numbers{0, 1, 2, 4, 5, 6, 7, 8}));
  EXPECT_NEAR(volume(), 1, 1e-14);
}

TEST_F(Domain_mesh, cuts_quadrangles)
{
  EXPECT_TRUE(read("cube.obj",
                   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                   "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::POLYGONAL_FACE});
  EXPECT_EQ(mesh.number_of_faces(), 12u);
  EXPECT_NEAR(volume(), 1, 1e-14);
}

TEST_F(Domain_mesh, reorients_what_has_one_reading)
{
  Soup mixed = meshes::sphere(1, 2);
  const Soup sphere = mixed;
  for(std::size_t f = 0; f < mixed.faces.size(); f += 5)
    std::swap(mixed.faces[f][0], mixed.faces[f][1]);
  EXPECT_TRUE(read(mixed));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::MIXED_ORIENTATION});
  EXPECT_EQ(defects[0].faces.size(), (mixed.faces.size() + 4) / 5);
  EXPECT_GT(volume(), 0);
  EXPECT_TRUE(read(sphere.inverted()));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::INVERTED_ORIENTATION});
  EXPECT_GT(volume(), 0);
}

TEST_F(Domain_mesh, knows_which_shells_are_cavities)
{
  const Soup outer = meshes::sphere(2, 2), inner = meshes::sphere(1, 2);
  const Soup island = meshes::sphere(.5, 1), beside = meshes::sphere(1, 1, Point(9, 0, 0));
  const auto accepts = [&](const Soup& soup) { return read(soup); };
  const Soup nest = outer + inner.inverted() + island;
  EXPECT_TRUE(accepts(nest + beside));
  EXPECT_TRUE(defects.empty());
  const double expected = volume();
  EXPECT_TRUE(accepts(beside + nest.inverted()));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::INVERTED_ORIENTATION});
  EXPECT_EQ(defects.size(), 3u) << "the three shells of the nest";
  EXPECT_NEAR(volume(), expected, 1e-12);
  EXPECT_FALSE(accepts(outer + inner + island)) << "two pairs that are turned the same way";
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::AMBIGUOUS_SHELLS});
  EXPECT_EQ(defects.size(), 2u);
  EXPECT_FALSE(accepts(outer + inner.inverted() + island.inverted()));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].shell, 3u);
}

TEST_F(Domain_mesh, finds_faces_that_intersect)
{
  EXPECT_FALSE(read(meshes::sphere(1, 2) + meshes::sphere(1, 2, Point(.7, .1, .2))));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::SELF_INTERSECTION});
  // a corner of one cube in the middle of a side of another one
  Soup cubes = meshes::cube(2), small = meshes::cube();
  for(Point& p : small.points) p = Point(p.x() + 2, p.y() + .5, p.z() + .5);
  EXPECT_FALSE(read(cubes + small)) << "they touch in a side";
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::SELF_INTERSECTION});
  // pulled through the opposite side: faces with a common vertex intersect
  Soup pulled = meshes::sphere(1, 1);
  pulled.points[4] = Point(0.01, 0.02, -2);
  EXPECT_FALSE(read(pulled));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::SELF_INTERSECTION});
}

// two faces without a common vertex: do their hulls meet?
bool do_meet(const Soup& soup, const Face& f, const Face& g)
{
  const auto hull = [&](const Face& face) {
    std::vector<brute_force::Vec<CGAL::Exact_rational>> points;
    for(const std::size_t v : face)
      points.push_back({soup.points[v].x(), soup.points[v].y(), soup.points[v].z()});
    return points;
  };
  return brute_force::do_hulls_meet(hull(f), hull(g));
}

TEST_F(Domain_mesh, finds_exactly_the_pairs_of_faces_that_brute_force_finds)
{
  Soup soup = meshes::voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  soup.points[3] = Point(2, 2, 0);
  soup.points[0] = Point(1, 1, 1);
  soup += meshes::sphere(1, 0, Point(1.5, .5, .5));
  const internal::Face_contacts<meshes::Kernel> contacts(soup.points, soup.faces);
  std::vector<std::pair<std::size_t, std::size_t>> expected;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    for(std::size_t g = f + 1; g < soup.faces.size(); ++g) {
      const bool are_in_contact = contacts.are_in_contact(f, g);
      if(are_in_contact) expected.push_back({f, g});
      const Face &s = soup.faces[f], &t = soup.faces[g];
      if(std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) == s.end()) {
        EXPECT_EQ(are_in_contact, do_meet(soup, s, t)) << f << " " << g;
      }
    }
  }
  EXPECT_EQ(contacts.find(), expected);
  EXPECT_FALSE(expected.empty());
}

TEST_F(Domain_mesh, tells_contacts_of_faces_with_common_vertices)
{
  const std::vector<Point> points = {{0, 0, 0}, {4, 0, 0},   {0, 4, 0}, {1, 1, 0},  {2, 2, 3},
                                     {5, 5, 0}, {-1, -1, 0}, {1, 1, 5}, {1, 1, -5}, {2, -3, 0}};
  const auto are_in_contact = [&](const Face& f, const Face& g) {
    const std::vector<Face> faces = {f, g};
    return internal::Face_contacts<meshes::Kernel>(points, faces).are_in_contact(0, 1);
  };
  EXPECT_FALSE(are_in_contact({0, 1, 2}, {2, 1, 4})) << "a common edge, at an angle";
  EXPECT_FALSE(are_in_contact({0, 1, 2}, {2, 1, 5})) << "in one plane, on either side";
  EXPECT_TRUE(are_in_contact({0, 1, 2}, {2, 1, 3})) << "in one plane, on the same side";
  EXPECT_TRUE(are_in_contact({0, 1, 2}, {1, 2, 0})) << "the same face";
  EXPECT_FALSE(are_in_contact({0, 1, 2}, {0, 6, 9})) << "in one plane, only a common vertex";
  EXPECT_TRUE(are_in_contact({0, 1, 2}, {0, 3, 4})) << "an edge lies in the other face";
  EXPECT_TRUE(are_in_contact({0, 1, 2}, {0, 7, 8})) << "the opposite edge passes through";
}

TEST_F(Domain_mesh, refuses_what_has_no_volume_or_no_size)
{
  Soup flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  flat.faces = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  EXPECT_FALSE(read(flat));
  EXPECT_NE(find(Kind::ZERO_VOLUME), nullptr);
  EXPECT_FALSE(read(meshes::cube(1e-160)));
  EXPECT_NE(find(Kind::SIZE_TOO_SMALL), nullptr);
  EXPECT_FALSE(read(meshes::cube(1e160)));
  EXPECT_NE(find(Kind::COORDINATE_TOO_LARGE), nullptr);
}

TEST_F(Domain_mesh, lists_a_thousand_of_a_kind_and_their_number)
{
  Soup soup = meshes::sphere(1, 4);
  for(Point& p : soup.points) p = Point(p.x(), p.y(), 0);
  EXPECT_FALSE(read(soup));
  const auto count = std::count_if(defects.begin(), defects.end(), [](const Mesh_defect& d) {
    return d.kind == Kind::SELF_INTERSECTION;
  });
  EXPECT_EQ(count, 1001);
}

TEST(Mesh_defect, is_printed_as_a_compiler_would)
{
  const Mesh_defect hole{Kind::OPEN_BOUNDARY, "a hole", 7, {1, 2}, {}};
  EXPECT_EQ(to_string(hole, "a.off"), "a.off:7: error: open boundary: a hole (vertices 1 2)");
  const Mesh_defect turned{Kind::MIXED_ORIENTATION, "two", 0, {}, {3}};
  EXPECT_EQ(to_string(turned, "a.off"), "a.off: warning: mixed orientation: two (face 3)");
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

TEST_F(Domain_mesh, has_values_at_its_vertices)
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

TEST_F(Domain_mesh, says_which_line_has_a_bad_value)
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
