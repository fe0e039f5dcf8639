// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_to_text.h"
#include "repair/repair_steps.h"
#include "repair/surface_distance.h"
#include "support/repair_test_support.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace test_repair_mesh {

using namespace repair_test;

Soup at(Soup soup, const Point& origin)
{
  for(Point& p : soup.points) p = p + (origin - CGAL::ORIGIN);
  return soup;
}

TEST_F(Repair, drops_degenerate_and_repeated_faces)
{
  Soup soup = meshes::cube();
  soup.faces.push_back({0, 0, 1});
  soup.faces.push_back(soup.faces[3]);
  const vfc::Mending mending = mend(soup);
  ASSERT_EQ(mending.steps.size(), 1u);
  EXPECT_EQ(mending.steps[0], "1 face without three corners dropped, 1 repeated face dropped");
  EXPECT_EQ(mesh.number_of_faces(), 12u);
  EXPECT_NEAR(volume(), 1, 1e-14);
  EXPECT_LT(mending.from_file, 1e-12);
  EXPECT_LT(mending.to_mended, 1e-12);
}

// The corner in the middle of an edge belongs to two faces with area, so it stays.
TEST_F(Repair, takes_out_faces_whose_corners_lie_on_a_line)
{
  Soup soup = meshes::cube();
  const Face f = soup.faces[0];
  soup.points.push_back(CGAL::midpoint(soup.points[f[0]], soup.points[f[1]]));
  soup.faces[0] = {f[0], 8, f[2]};
  soup.faces.push_back({8, f[1], f[2]});
  soup.faces.push_back({f[0], f[1], 8});
  const vfc::Mending mending = mend(soup);
  EXPECT_FALSE(is_wrapped(mending));
  EXPECT_EQ(mesh.number_of_vertices(), 9u);
  for(const auto face : mesh.faces())
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(face, mesh));
  EXPECT_NEAR(volume(), 1, 1e-12);
  EXPECT_LT(mending.from_file, 1e-12);
}

TEST_F(Repair, closes_holes)
{
  Soup soup = meshes::sphere(1, 3);
  const double whole = CGAL::Polygon_mesh_processing::volume(meshes::to_mesh(soup));
  soup.faces.erase(soup.faces.begin() + 100);
  soup.faces.erase(soup.faces.begin(), soup.faces.begin() + 4);
  const vfc::Mending mending = mend(soup);
  ASSERT_EQ(mending.steps.size(), 1u);
  EXPECT_NE(mending.steps[0].find("2 holes closed"), std::string::npos) << mending.steps[0];
  EXPECT_NEAR(volume(), whole, 0.01);
  EXPECT_GT(mending.from_file, 0.02) << "the middle of a patch is that far from its border";
  EXPECT_LT(mending.from_file, 0.15);
}

TEST_F(Repair, merges_what_rounding_has_torn_apart)
{
  const Soup whole = meshes::sphere(1, 2);
  Soup torn;
  for(const Face& f : whole.faces) { // every face with corners of its own
    const double noise = 1e-8 * static_cast<double>(torn.faces.size() % 7);
    for(const std::size_t v : f)
      torn.points.push_back(whole.points[v] + meshes::Kernel::Vector_3(noise, -noise, noise));
    const std::size_t n = torn.points.size();
    torn.faces.push_back({n - 3, n - 2, n - 1});
  }
  const vfc::Mending mending = mend(torn);
  EXPECT_FALSE(is_wrapped(mending));
  EXPECT_EQ(mesh.number_of_faces(), whole.faces.size());
  EXPECT_LT(mending.from_file, 1e-6);
}

TEST_F(Repair, drops_a_fin)
{
  Soup soup = meshes::sphere(1, 2);
  soup.points.push_back(Point(1.1, 1.1, 0));
  soup.faces.push_back({soup.faces[0][0], soup.faces[0][1], soup.points.size() - 1});
  const vfc::Mending mending = mend(soup);
  EXPECT_FALSE(is_wrapped(mending));
  EXPECT_EQ(mesh.number_of_faces(), soup.faces.size() - 1);
  EXPECT_GT(mending.to_mended, 0.1) << "the fin is gone, and that is said";
}

TEST_F(Repair, cuts_out_self_intersections)
{
  Soup pulled = meshes::sphere(1, 3);
  for(Point& p : pulled.points)
    if(p.z() > 0.95) p = Point(p.x(), p.y(), -1.1); // a spike through the other side
  const vfc::Mending mending = mend(pulled);
  EXPECT_FALSE(is_wrapped(mending));
  EXPECT_GT(volume(), 1);
  EXPECT_LT(volume(), 4.2);
}

TEST_F(Repair, unites_shells)
{
  const Soup a = meshes::cube(2);
  Soup b = a, c = meshes::cube(), far = a;
  for(Point& p : b.points) p = Point(p.x() + 1, p.y() + 1, p.z() + 1);
  for(Point& p : c.points) p = Point(p.x() + .25, p.y() + .25, p.z() + .25); // within a, as a solid
  for(Point& p : far.points) p = Point(p.x() + 9, p.y(), p.z());
  const vfc::Mending mending = mend(a + b + c + far.inverted());
  EXPECT_FALSE(is_wrapped(mending));
  EXPECT_NEAR(volume(), 8 + 8 - 1 + 8, 1e-12);
  EXPECT_LT(mending.from_file, 1e-12);
  EXPECT_GT(mending.to_mended, 0.2) << "what was inside of the union";
}

TEST_F(Repair, keeps_the_cavity_where_shells_are_united)
{
  const Soup outer = meshes::sphere(3, 2), cavity = meshes::sphere(1, 2).inverted();
  mend(outer + meshes::sphere(3, 2, Point(4, .1, .2)) + cavity);
  const double ball = CGAL::Polygon_mesh_processing::volume(meshes::to_mesh(outer));
  const double hollow = CGAL::Polygon_mesh_processing::volume(meshes::to_mesh(cavity));
  EXPECT_LT(hollow, 0);
  EXPECT_LT(volume(), 2 * ball + hollow);
  EXPECT_GT(volume(), 1.5 * ball + hollow);
}

// A cavity is turned inside out. One that touches the bottom is a pit, one that pokes through it
// takes less away, and an island in one that touches its floor stays.
TEST_F(Repair, keeps_cavities_that_touch_or_cross_the_wall)
{
  const Soup block = meshes::cube(3), hole = at(meshes::cube(), Point(1, 1, 0)).inverted();
  EXPECT_FALSE(is_wrapped(mend(block + hole)));
  EXPECT_NEAR(volume(), 26, 1e-12);
  const vfc::Mending mending = mend(block + at(hole, Point(.01, .02, -.5)));
  EXPECT_NEAR(volume(), 26.5, 1e-12);
  ASSERT_FALSE(is_wrapped(mending));
  EXPECT_NE(mending.steps[0].find("subtracted as a cavity"), std::string::npos);
  mend(at(meshes::cube(9), Point(-3, -3, -3)) + block.inverted() + hole.inverted());
  EXPECT_NEAR(volume(), 729 - 27 + 1, 1e-9);
}

// A mesh that is inside out as a whole is reversed first.
TEST_F(Repair, takes_the_largest_of_shells_that_meet_for_a_solid)
{
  mend((meshes::cube(3) + at(meshes::cube(), Point(1, 1, -.5)).inverted()).inverted());
  EXPECT_NEAR(volume(), 26.5, 1e-12);
}

// Two cubes with a common edge: no mesh without a gap can have it.
TEST_F(Repair, wraps_what_nothing_else_mends)
{
  const Soup cubes = meshes::voxels({{0, 0, 0}, {1, 1, 0}});
  for(const double alpha : {0.2, 0.1}) {
    const vfc::Mending mending = mend(cubes, alpha);
    EXPECT_TRUE(is_wrapped(mending));
    EXPECT_GT(volume(), 2) << "it goes around";
    EXPECT_GT(mending.from_file, alpha / 31);
    EXPECT_LT(mending.from_file, alpha);
    EXPECT_LT(mending.to_mended, alpha);
  }
}

TEST_F(Repair, gives_equal_meshes_for_equal_inputs)
{
  const Soup soup = meshes::sphere(1, 2) + meshes::sphere(1, 2, Point(.7, .1, .2));
  const vfc::Mending first = mend(soup);
  const std::string text = vfc::to_text(mesh, ".ply");
  const vfc::Mending second = mend(soup);
  EXPECT_EQ(first.steps, second.steps);
  EXPECT_EQ(first.from_file, second.from_file);
  EXPECT_EQ(vfc::to_text(mesh, ".ply"), text);
}

// A step without any repair reports nothing.
TEST_F(Repair, leaves_a_sound_mesh_alone)
{
  const Soup soup = meshes::sphere(1, 2);
  mesh = meshes::to_mesh(soup);
  vfc::Work_watch no_limit;
  for(const auto step : {vfc::merge_near_vertices, vfc::drop_sheets, vfc::remove_flat_faces,
                         vfc::close_holes, vfc::remove_self_intersections, vfc::unite_shells})
    EXPECT_EQ(step(mesh, no_limit), "");
  EXPECT_EQ(mesh.number_of_faces(), soup.faces.size());
}

TEST(Surface_distance, is_that_of_spheres_and_sheets)
{
  vfc::Work_watch no_limit;
  const auto distance = [&](const vfc::Mesh& from, const vfc::Mesh& to) {
    return vfc::surface_distance(from, to, no_limit);
  };
  const vfc::Mesh ball = meshes::to_mesh(meshes::sphere(1, 4));
  const vfc::Mesh large = meshes::to_mesh(meshes::sphere(1.5, 4));
  EXPECT_NEAR(distance(ball, large), 0.5, 0.01);
  EXPECT_NEAR(distance(large, ball), 0.5, 0.01);
  EXPECT_LT(distance(ball, ball), 1e-12);
  const vfc::Mesh two =
      meshes::to_mesh(meshes::sphere(1, 4) + meshes::sphere(1, 4, Point(5, 0, 0)));
  EXPECT_LT(distance(ball, two), 1e-12) << "one way only";
  EXPECT_NEAR(distance(two, ball), 5, 0.01);
}

} // namespace test_repair_mesh
