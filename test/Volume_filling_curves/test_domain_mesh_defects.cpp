// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "domain_mesh_test_support.h"
#include "exact_brute_force.h"

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace domain_mesh_test;

using Domain_mesh_defects = Domain_mesh;

TEST_F(Domain_mesh_defects, lists_every_hole)
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

TEST_F(Domain_mesh_defects, lists_degenerate_and_duplicate_faces)
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

TEST_F(Domain_mesh_defects, refuses_an_edge_of_four_faces)
{
  EXPECT_FALSE(read(meshes::voxels({{0, 0, 0}, {1, 1, 0}})));
  ASSERT_EQ(kinds(), std::vector<Kind>{Kind::NON_MANIFOLD_EDGE});
  EXPECT_EQ(defects[0].faces.size(), 4u);
  EXPECT_EQ(defects[0].vertices.size(), 2u);
}

TEST_F(Domain_mesh_defects, splits_a_vertex_where_two_cubes_touch)
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

TEST_F(Domain_mesh_defects, merges_vertices_and_leaves_out_unused_ones)
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

TEST_F(Domain_mesh_defects, cuts_quadrangles)
{
  EXPECT_TRUE(read("cube.obj",
                   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                   "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"));
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::POLYGONAL_FACE});
  EXPECT_EQ(mesh.number_of_faces(), 12u);
  EXPECT_NEAR(volume(), 1, 1e-14);
}

TEST_F(Domain_mesh_defects, reorients_what_has_one_reading)
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

TEST_F(Domain_mesh_defects, knows_which_shells_are_cavities)
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

TEST_F(Domain_mesh_defects, finds_faces_that_intersect)
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

TEST_F(Domain_mesh_defects, finds_exactly_the_pairs_of_faces_that_brute_force_finds)
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

TEST_F(Domain_mesh_defects, tells_contacts_of_faces_with_common_vertices)
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

TEST_F(Domain_mesh_defects, refuses_what_has_no_volume_or_no_size)
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

TEST_F(Domain_mesh_defects, lists_a_thousand_of_a_kind_and_their_number)
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

} // namespace
