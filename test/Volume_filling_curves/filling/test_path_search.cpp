// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Path_search.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// Paths around walls and through necks.
namespace test_path_search {

using namespace CGAL::Volume_filling_curves;
using exact_surface::Point;
using internal::Vector;
using Mesh_domain = Triangle_mesh_domain_3<>;
using Traits = Curve_flow_traits_3<>;
using Paths = internal::Path_search<Mesh_domain, Traits>;

constexpr std::size_t many = 100000;

Point to_point(const Vector& p)
{
  return {p.x(), p.y(), p.z()};
}

void expect_path_inside(const Mesh_domain& domain, Vector from, const std::vector<Vector>& path)
{
  for(const Vector& to : path) {
    EXPECT_TRUE(domain.is_inside(to_point(to)));
    EXPECT_TRUE(domain.is_triangle_inside(to_point(from), to_point(to), to_point(to)));
    from = to;
  }
}

TEST(Path_search, lead_around_a_wall_in_short_hops)
{
  const Mesh_domain domain(meshes::to_mesh(exact_surface::two_legs(0.1)));
  const Vector start(1.6, 2.5, 0.5), goal(0.5, 2.6, 0.4);
  Paths paths(domain, Traits(), many);
  ASSERT_TRUE(paths.search(start, 0.2, [&](const Vector& p) { return paths.sees(goal, p); }));
  for(const double longest : {0.6, 10.}) {
    const std::vector<Vector> path = paths.path_from(goal, longest);
    EXPECT_EQ(path.back(), start);
    expect_path_inside(domain, goal, path);
    for(std::size_t k = 1; k < path.size(); ++k) EXPECT_LE((path[k] - path[k - 1]).norm(), longest);
    if(longest > 1) {
      EXPECT_LT(path.size(), 6u); // taut
    }
  }
}

TEST(Path_search, lead_through_a_neck_that_cells_fit_into)
{
  const Mesh_domain domain(meshes::to_mesh(exact_surface::two_chambers()));
  const Vector start(2.5, 0.3, 0.7), goal(0.2, 0.8, 0.3);
  const auto sees_goal = [&](Paths& paths) {
    return [&](const Vector& p) { return paths.sees(goal, p); };
  };
  Paths paths(domain, Traits(), many);
  EXPECT_FALSE(paths.search(start, 0.25, sees_goal(paths)));
  ASSERT_TRUE(paths.search(start, 0.0625, sees_goal(paths)));
  const std::vector<Vector> path = paths.path_from(goal, 1);
  expect_path_inside(domain, goal, path);
  for(const Vector& p : paths.path()) EXPECT_TRUE(domain.is_inside(to_point(p)));
}

TEST(Path_search, see_across_a_segment_with_clearance)
{
  const Mesh_domain domain(meshes::to_mesh(exact_surface::two_chambers()));
  Paths paths(domain, Traits(), many);
  ASSERT_TRUE(paths.search(Vector(0.5, 0.5, 0.5), 0.125, [](const Vector&) { return true; }));
  EXPECT_TRUE(paths.sees(Vector(0.5, 0.5, 0.5), Vector(2.5, 0.5, 0.5)));
  EXPECT_TRUE(paths.sees(Vector(0.1, 0.1, 0.1), Vector(0.9, 0.9, 0.9)));
  EXPECT_FALSE(paths.sees(Vector(0.5, 0.2, 0.5), Vector(2.5, 0.2, 0.5)));
  EXPECT_FALSE(paths.sees(Vector(0.5, 0.5, 0.5), Vector(0.5, 1.5, 0.5))); // outside
}

// Of two separate cubes; another search finds out in one cell what the first one found.
TEST(Path_search, look_once_where_there_is_none)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::voxels({{0, 2, 0}, {2, 2, 0}})));
  std::size_t shown = 0;
  const auto count = [&](const Vector&) { return ++shown == 0; };
  Paths paths(domain, Traits(), many);
  EXPECT_FALSE(paths.search(Vector(2.5, 2.5, 0.5), 0.125, count));
  EXPECT_GT(shown, 100u);
  EXPECT_LT(shown, 600u);
  const std::size_t shown_first = shown;
  EXPECT_FALSE(paths.search(Vector(2.2, 2.3, 0.3), 0.125, count));
  EXPECT_EQ(shown, shown_first);
  EXPECT_FALSE(paths.search(Vector(0.5, 2.5, 0.5), 0.125, count)); // the other cube
  EXPECT_GT(shown, shown_first);
}

TEST(Path_search, end_after_so_many_cells)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::voxels({{0, 0, 0}})));
  std::size_t shown = 0;
  Paths paths(domain, Traits(), 20);
  EXPECT_FALSE(paths.search(Vector(0.5, 0.5, 0.5), 0.01, [&](const Vector&) { return !++shown; }));
  EXPECT_EQ(shown, 20u);
}

} // namespace test_path_search
