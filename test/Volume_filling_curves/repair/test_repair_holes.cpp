// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"
#include "support/repair_test_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace test_repair_holes {

using namespace repair_test;

Point center(const Soup& soup, const Face& f)
{
  return CGAL::centroid(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]);
}

template <typename Predicate>
Soup without(Soup soup, const Predicate& is_dropped)
{
  std::vector<Face> kept;
  for(const Face& f : soup.faces)
    if(!is_dropped(f)) kept.push_back(f);
  soup.faces = kept;
  return soup;
}

// A sphere with 32 holes all over it, whose radii grow from 0.04 to 0.2.
Soup sieve()
{
  const Soup whole = meshes::sphere(1, 4);
  std::vector<std::pair<Point, double>> holes;
  for(int i = 0; i < 32; ++i) {
    const double z = 1 - (2 * i + 1) / 32., r = std::sqrt(1 - z * z), turn = 2.399963 * i;
    holes.push_back({Point(r * std::cos(turn), r * std::sin(turn), z), 0.04 + 0.16 * i / 31});
  }
  return without(whole, [&](const Face& f) {
    for(const auto& [point, radius] : holes)
      if(CGAL::squared_distance(center(whole, f), point) < radius * radius) return true;
    return false;
  });
}

// Every face has corners of its own, as in an STL file.
Soup torn(const Soup& soup)
{
  Soup result;
  for(const Face& f : soup.faces) {
    for(const std::size_t v : f) result.points.push_back(soup.points[v]);
    const std::size_t n = result.points.size();
    result.faces.push_back({n - 3, n - 2, n - 1});
  }
  return result;
}

TEST_F(Repair, closes_32_holes_of_a_sphere)
{
  for(const Soup& soup : {sieve(), torn(sieve())}) {
    const vfc::Mending mending = mend(soup);
    EXPECT_EQ(mending.steps[0].find("32 holes closed"), 0u) << mending.steps[0];
    EXPECT_NEAR(volume(), 4.17, 0.02);
    EXPECT_LT(mending.from_file, 0.2);
  }
}

// A bath tub: a box without a top, with a rim that goes outward.
TEST_F(Repair, closes_a_bath_tub)
{
  Soup tub = meshes::voxels({{0, 0, 0}, {1, 0, 0}});
  tub = without(tub, [&](const Face& f) { return center(tub, f).z() == 1; });
  const std::size_t first = tub.points.size();
  tub.points.insert(tub.points.end(), {{-.2, -.2, 1},
                                       {2.2, -.2, 1},
                                       {2.2, 1.2, 1},
                                       {-.2, 1.2, 1},
                                       {0, 0, 1},
                                       {2, 0, 1},
                                       {2, 1, 1},
                                       {0, 1, 1}});
  for(std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    tub.faces.push_back({first + i, first + j, first + 4 + j});
    tub.faces.push_back({first + i, first + 4 + j, first + 4 + i});
  }
  mend(tub);
  EXPECT_GT(volume(), 1.9);
}

// Holes that touch each other are ten holes and more, and no reason to wrap the mesh.
TEST_F(Repair, closes_holes_that_touch_one_by_one)
{
  const Soup whole = meshes::sphere(1, 3);
  std::mt19937 random(1);
  std::size_t left = 40;
  const vfc::Mending mending = mend(
      without(whole, [&](const Face&) { return left > 0 && random() % 12 == 0 && left-- > 0; }));
  EXPECT_FALSE(is_wrapped(mending)) << mending.steps.back();
  EXPECT_NEAR(volume(), 4.1, 0.15);
}

// Fins make edges of three faces, along which a mesh is cut and partly stitched again; holes leave
// borders that stay. Vertices that stitching had removed once made indices that lay outside.
TEST_F(Repair, mends_what_has_stitched_and_remaining_borders)
{
  const Soup whole = meshes::sphere(1, 2);
  for(unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 random(seed);
    Soup soup = without(whole, [&](const Face&) { return random() % 12 == 0; });
    for(int i = 0; i < 8; ++i) {
      const Face f = soup.faces[random() % soup.faces.size()];
      soup.faces.push_back({f[0], f[1], random() % soup.points.size()});
    }
    vfc::Mesh assembled;
    vfc::Work_watch watch;
    vfc::assemble_faces(faces_of(soup), assembled, watch);
    EXPECT_FALSE(assembled.has_garbage());
    mend(soup, 0.5);
  }
}

TEST_F(Repair, mends_seven_faces_around_one_vertex)
{
  Soup soup;
  soup.points = {{2.95, 0, 0},       {3.05, 0, 0},       {3, -0.03, -0.04},  {2.86, 0.48, -0.32},
                 {2.95, 0.5, -0.34}, {2.9, 0.46, -0.37}, {0.34, 2.9, -0.52}, {0.29, 2.86, -0.48}};
  soup.faces = {{0, 2, 4}, {5, 1, 2}, {3, 2, 0}, {5, 2, 3}, {2, 6, 7}, {1, 6, 2}, {2, 7, 0}};
  mend(soup);
}

// A step of CGAL's leaves connectivity that leads nowhere, which must not reach the next one.
TEST_F(Repair, goes_back_where_a_step_leaves_no_valid_mesh)
{
  Soup soup;
  soup.points = {{5, 2, 1}, {1, 5, 5}, {0, 4, 1}, {0, 4, 3},
                 {2, 0, 0}, {3, 1, 0}, {5, 3, 0}, {5, 2, 2}};
  soup.points[5] = Point(3, 1, -1e-9);
  soup.faces = {{4, 0, 6}, {2, 1, 5}, {5, 4, 3}, {1, 7, 2}, {5, 5, 5}, {7, 1, 0},
                {2, 3, 3}, {5, 7, 3}, {3, 6, 6}, {6, 3, 4}, {4, 5, 7}, {4, 3, 6},
                {3, 2, 4}, {3, 4, 7}, {5, 3, 3}, {7, 5, 4}, {1, 5, 2}, {3, 5, 5},
                {1, 7, 4}, {1, 2, 7}, {5, 6, 4}, {3, 5, 7}, {4, 6, 6}};
  mend(soup, 1);
}

// There is nothing to wrap.
TEST_F(Repair, leaves_faces_without_area_as_they_are)
{
  Soup point, line;
  point.points = line.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  point.faces = {{0, 0, 0}};
  line.faces = {{0, 1, 2}, {0, 0, 3}};
  for(const Soup& soup : {point, line}) {
    vfc::Work_watch no_limit;
    EXPECT_TRUE(vfc::repair_mesh(faces_of(soup), 0, mesh, no_limit).steps.size() < 2);
    EXPECT_FALSE(vfc::is_sound(mesh, no_limit));
  }
}

} // namespace test_repair_holes
