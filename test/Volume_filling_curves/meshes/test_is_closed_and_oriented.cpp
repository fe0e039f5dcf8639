// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_checks.h"

#include "support/mesh_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

// Whether a soup is a closed surface as it stands.
namespace test_is_closed_and_oriented {

using meshes::Soup;

bool is_closed_and_oriented(const Soup& soup)
{
  vfc::Mesh_soup faces;
  faces.points.assign(soup.points.begin(), soup.points.end());
  faces.faces.assign(soup.faces.begin(), soup.faces.end());
  return vfc::is_closed_and_oriented(faces);
}

TEST(Is_closed_and_oriented, what_bounds_something)
{
  EXPECT_TRUE(is_closed_and_oriented(meshes::cube()));
  EXPECT_TRUE(is_closed_and_oriented(meshes::sphere(1, 2)));
  EXPECT_TRUE(is_closed_and_oriented(meshes::sphere(1, 2).inverted()));
  EXPECT_TRUE(is_closed_and_oriented(meshes::sphere(2, 1) + meshes::sphere(0.5, 1)));
}

TEST(Is_closed_and_oriented, not_what_has_a_hole)
{
  Soup soup = meshes::sphere(1, 2);
  soup.faces.erase(soup.faces.begin() + 17);
  EXPECT_FALSE(is_closed_and_oriented(soup));
  soup.faces.resize(1);
  EXPECT_FALSE(is_closed_and_oriented(soup));
}

TEST(Is_closed_and_oriented, not_what_has_a_face_turned_or_twice)
{
  Soup turned = meshes::sphere(1, 2), twice = turned, both = turned;
  std::swap(turned.faces[5][0], turned.faces[5][1]);
  EXPECT_FALSE(is_closed_and_oriented(turned));
  twice.faces.push_back(twice.faces[5]);
  EXPECT_FALSE(is_closed_and_oriented(twice));
  both.faces.push_back(turned.faces[5]);
  both.faces.push_back(both.faces[5]);
  EXPECT_FALSE(is_closed_and_oriented(both));
}

TEST(Is_closed_and_oriented, not_what_touches_itself)
{
  EXPECT_FALSE(is_closed_and_oriented(meshes::voxels({{0, 0, 0}, {1, 1, 0}}))); // in an edge
  EXPECT_FALSE(is_closed_and_oriented(meshes::voxels({{0, 0, 0}, {1, 1, 1}}))); // in a vertex
}

} // namespace test_is_closed_and_oriented
