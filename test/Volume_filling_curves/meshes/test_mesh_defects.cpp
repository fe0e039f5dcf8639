// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/examine_mesh.h"
#include "support/exact_brute_force.h"
#include "support/mesh_file_test_support.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace test_mesh_defects {

using namespace mesh_file_test;

using Mesh_defects = Mesh_file;

TEST_F(Mesh_defects, lists_every_hole)
{
  Soup soup = meshes::sphere(1, 2);
  soup.faces.erase(soup.faces.begin() + 100);
  soup.faces.erase(soup.faces.begin());
  EXPECT_FALSE(read(soup));
  EXPECT_EQ(kinds(), Kinds{"open boundary"});
  ASSERT_EQ(defects.size(), 2u);
  EXPECT_EQ(defects[0].nodes.size(), 3u);
  EXPECT_NE(defects[0].message.find("boundary of 3 edges"), std::string::npos);
}

TEST_F(Mesh_defects, lists_degenerate_and_duplicate_faces)
{
  Soup soup = meshes::cube();
  soup.faces.push_back({0, 0, 1});
  soup.faces.push_back(soup.faces[3]);
  soup.points.push_back(CGAL::midpoint(soup.points[0], soup.points[1]));
  soup.faces.push_back({0, 8, 1});
  EXPECT_FALSE(read(soup));
  const vfc::Defect* const degenerate = find("degenerate face");
  ASSERT_NE(degenerate, nullptr);
  EXPECT_EQ(degenerate->faces, Numbers{13});
  EXPECT_EQ(std::count_if(defects.begin(), defects.end(),
                          [](const vfc::Defect& d) { return d.kind == "degenerate face"; }),
            2);
  const vfc::Defect* const duplicate = find("duplicate face");
  ASSERT_NE(duplicate, nullptr);
  EXPECT_EQ(duplicate->faces, (Numbers{4, 14}));
  EXPECT_NE(find("non-manifold edge"), nullptr);
}

TEST_F(Mesh_defects, refuses_an_edge_of_four_faces)
{
  EXPECT_FALSE(read(meshes::voxels({{0, 0, 0}, {1, 1, 0}})));
  ASSERT_EQ(kinds(), Kinds{"non-manifold edge"});
  EXPECT_NE(defects[0].message.find("4 faces"), std::string::npos);
  EXPECT_EQ(defects[0].nodes.size(), 2u);
}

TEST_F(Mesh_defects, splits_a_vertex_where_two_cubes_touch)
{
  EXPECT_TRUE(read(meshes::voxels({{0, 0, 0}, {1, 1, 1}})));
  ASSERT_EQ(kinds(), Kinds{"non-manifold vertex"});
  EXPECT_EQ(mesh.number_of_vertices(), 16u);
  EXPECT_NEAR(volume(), 2, 1e-14);
  EXPECT_EQ(origins.size(), 16u);
  EXPECT_EQ(origins.back() + 1, defects[0].nodes.at(0));
  const vfc::Domain domain(mesh);
  EXPECT_FALSE(domain.is_triangle_inside({.5, .5, .5}, {1.5, 1.5, 1.5}, {.5, .5, .5}));
}

TEST_F(Mesh_defects, merges_vertices_and_leaves_out_unused_ones)
{
  Soup soup = meshes::cube();
  soup.points.push_back(soup.points[0]);
  soup.points.insert(soup.points.begin() + 3, Point(5, 5, 5));
  for(Face& f : soup.faces)
    for(std::size_t& v : f) v += v >= 3;
  for(std::size_t& v : soup.faces[0])
    if(v == 0) v = 9;
  EXPECT_TRUE(read(soup));
  EXPECT_EQ(kinds(), (Kinds{"coincident vertices", "isolated vertex"}));
  EXPECT_EQ(find("coincident vertices")->nodes, Numbers{10});
  EXPECT_EQ(find("isolated vertex")->nodes, Numbers{4});
  ASSERT_EQ(origins.size(), 8u);
  for(const auto v : mesh.vertices()) EXPECT_EQ(mesh.point(v), soup.points[origins[v]]);
  EXPECT_NEAR(volume(), 1, 1e-14);
}

TEST_F(Mesh_defects, cuts_quadrangles)
{
  EXPECT_TRUE(read("cube.obj",
                   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                   "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"));
  EXPECT_EQ(kinds(), Kinds{"polygonal face"});
  EXPECT_EQ(mesh.number_of_faces(), 12u);
  EXPECT_NEAR(volume(), 1, 1e-14);
}

TEST_F(Mesh_defects, reorients_what_has_one_reading)
{
  Soup mixed = meshes::sphere(1, 2);
  const Soup sphere = mixed;
  for(std::size_t f = 0; f < mixed.faces.size(); f += 5)
    std::swap(mixed.faces[f][0], mixed.faces[f][1]);
  EXPECT_TRUE(read(mixed));
  EXPECT_EQ(kinds(), Kinds{"mixed orientation"});
  EXPECT_EQ(defects[0].faces.size(), (mixed.faces.size() + 4) / 5);
  EXPECT_GT(volume(), 0);
  EXPECT_TRUE(read(sphere.inverted()));
  EXPECT_EQ(kinds(), Kinds{"inverted orientation"});
  EXPECT_GT(volume(), 0);
}

TEST_F(Mesh_defects, finds_faces_that_intersect)
{
  EXPECT_FALSE(read(meshes::sphere(1, 2) + meshes::sphere(1, 2, Point(.7, .1, .2))));
  EXPECT_EQ(kinds(), Kinds{"self-intersection"});
  // a corner of one cube in the middle of a side of another one
  Soup cubes = meshes::cube(2), small = meshes::cube();
  for(Point& p : small.points) p = Point(p.x() + 2, p.y() + .5, p.z() + .5);
  EXPECT_FALSE(read(cubes + small)) << "they touch in a side";
  EXPECT_EQ(kinds(), Kinds{"self-intersection"});
  // pulled through the opposite side: faces with a common vertex intersect
  Soup pulled = meshes::sphere(1, 1);
  pulled.points[4] = Point(0.01, 0.02, -2);
  EXPECT_FALSE(read(pulled));
  EXPECT_EQ(kinds(), Kinds{"self-intersection"});
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

TEST_F(Mesh_defects, include_the_pairs_of_faces_that_brute_force_finds)
{
  Soup soup = meshes::voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  soup.points[3] = Point(2, 2, 0);
  soup.points[0] = Point(1.1, 1.2, .9);
  soup += meshes::sphere(1, 0, Point(1.5, .5, .5));
  EXPECT_FALSE(read(soup));
  std::vector<Numbers> found;
  for(const vfc::Defect& d : defects)
    if(d.kind == "self-intersection") found.push_back(d.faces);
  std::size_t expected = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    for(std::size_t g = f + 1; g < soup.faces.size(); ++g) {
      const Face &s = soup.faces[f], &t = soup.faces[g];
      if(std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end()) continue;
      const bool is_found = std::count(found.begin(), found.end(), Numbers{f + 1, g + 1}) == 1;
      EXPECT_EQ(is_found, do_meet(soup, s, t)) << f << " " << g;
      expected += is_found;
    }
  }
  EXPECT_GT(expected, 0u);
}

// Two faces with common corners, which need not be common vertices of a mesh.
TEST_F(Mesh_defects, tell_contacts_of_faces_with_common_corners)
{
  const std::vector<Point> points = {{0, 0, 0}, {4, 0, 0},   {0, 4, 0}, {1, 1, 0},  {2, 2, 3},
                                     {5, 5, 0}, {-1, -1, 0}, {1, 1, 5}, {1, 1, -5}, {2, -3, 0}};
  const auto are_in_contact = [&](const Face& f, const Face& g) {
    EXPECT_FALSE(read({points, {f, g}}));
    return find("self-intersection") != nullptr;
  };
  EXPECT_FALSE(are_in_contact({0, 1, 2}, {2, 1, 4})) << "a common edge, at an angle";
  EXPECT_FALSE(are_in_contact({0, 1, 2}, {2, 1, 5})) << "in one plane, on either side";
  EXPECT_TRUE(are_in_contact({0, 1, 2}, {2, 1, 3})) << "in one plane, on the same side";
  EXPECT_FALSE(are_in_contact({0, 1, 2}, {0, 6, 9})) << "in one plane, only a common corner";
  EXPECT_TRUE(are_in_contact({0, 1, 2}, {0, 3, 4})) << "an edge lies in the other face";
  EXPECT_TRUE(are_in_contact({0, 1, 2}, {0, 7, 8})) << "the opposite edge passes through";
}

TEST_F(Mesh_defects, refuses_what_has_no_volume_or_no_size)
{
  Soup flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  flat.faces = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  EXPECT_FALSE(read(flat));
  EXPECT_NE(find("zero volume"), nullptr);
  EXPECT_FALSE(read(meshes::cube(1e-160)));
  EXPECT_NE(find("size too small"), nullptr);
  EXPECT_TRUE(read(meshes::cube(1e99)));
  for(const double size : {1e101, 6e102, 1e140, 1e160}) {
    EXPECT_FALSE(read(meshes::cube(size))) << "its volume may overflow";
    EXPECT_EQ(kinds(), Kinds{"coordinate too large"});
  }
}

TEST_F(Mesh_defects, lists_a_thousand_of_a_kind_and_their_number)
{
  Soup soup = meshes::sphere(1, 4);
  for(Point& p : soup.points) p = Point(p.x(), p.y(), 0);
  EXPECT_FALSE(read(soup));
  const auto count = std::count_if(defects.begin(), defects.end(), [](const vfc::Defect& d) {
    return d.kind == "self-intersection";
  });
  EXPECT_EQ(count, 1001);
}

TEST_F(Mesh_defects, are_summed_up_by_kind)
{
  Soup soup = meshes::sphere(1, 3);
  soup.faces.erase(soup.faces.begin() + 100);
  soup.faces.erase(soup.faces.begin(), soup.faces.begin() + 4);
  soup.points.push_back(Point(9, 9, 9));
  vfc::Mesh_findings findings("a.off");
  vfc::Mesh_soup faces;
  faces.points = soup.points;
  faces.faces = soup.faces;
  faces.face_numbers.assign(soup.faces.size(), 1);
  EXPECT_FALSE(vfc::examine(faces, findings).is_valid);
  EXPECT_TRUE(findings.is_mendable());
  const vfc::Defects summary = findings.summary();
  ASSERT_EQ(summary.size(), 2u);
  EXPECT_FALSE(summary[0].is_error) << "the isolated vertex";
  EXPECT_EQ(summary[1].kind, "open boundary");
  EXPECT_EQ(summary[1].nodes.size(), 6u) << "the widest of the holes";
  EXPECT_NE(summary[1].message.find("wide, near ("), std::string::npos) << summary[1].message;
  EXPECT_NE(summary[1].message.find(", the first of 2; repair closes holes"), std::string::npos);
  findings.add_error("non-finite coordinate", "a coordinate is not finite");
  EXPECT_FALSE(findings.is_mendable());
}

TEST(Mesh_defect, is_printed_as_a_compiler_would)
{
  const vfc::Defect hole("open boundary", true, "a.off", {7, {1, 2}}, "a hole");
  EXPECT_EQ(hole.text, "a.off:7: error: open boundary: a hole (vertices 1 2)");
  const vfc::Defect turned("mixed orientation", false, "a.off", {0, {}, {3}}, "two");
  EXPECT_EQ(turned.text, "a.off: warning: mixed orientation: two (face 3)");
}

} // namespace test_mesh_defects
