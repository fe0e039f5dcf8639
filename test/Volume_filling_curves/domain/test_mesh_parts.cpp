// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <set>
#include <vector>

// Which points inside of a mesh are connected inside.
namespace test_mesh_parts {

using namespace CGAL::Volume_filling_curves;
using exact_surface::Surface;
using meshes::Point;
using meshes::Soup;
using Mesh_domain = Triangle_mesh_domain_3<>;

Soup moved(Soup soup, double x, double y, double z)
{
  for(Point& p : soup.points) p = {p.x() + x, p.y() + y, p.z() + z};
  return soup;
}

// Points are in one part exactly if the same shells enclose them.
void expect_parts(const std::vector<Soup>& shells, std::size_t number)
{
  Soup all;
  std::vector<Surface> surfaces;
  for(const Soup& shell : shells) {
    all += shell;
    surfaces.emplace_back(shell);
  }
  const Mesh_domain domain(meshes::to_mesh(all), parameters::check_mesh(false));
  std::map<std::size_t, std::vector<bool>> shells_around;
  CGAL::Random random(1);
  const CGAL::Bbox_3 box = domain.bbox();
  for(int k = 0; k < 300; ++k) {
    // among them points above vertices and edges
    const auto coordinate = [&](int i) {
      return box.min(i) + (box.max(i) - box.min(i)) * random.get_int(1, 32) / 32;
    };
    const Point p(coordinate(0), coordinate(1), coordinate(2));
    if(!domain.is_inside(p)) continue;
    std::vector<bool> around;
    for(const Surface& surface : surfaces) around.push_back(surface.is_inside(p));
    EXPECT_EQ(shells_around.insert({domain.part(p), around}).first->second, around);
    const CGAL::Bbox_3 part_box = domain.part_boxes()[domain.part(p)];
    EXPECT_EQ(part_box + p.bbox(), part_box);
  }
  EXPECT_EQ(shells_around.size(), number);
  std::set<std::vector<bool>> different;
  for(const auto& [part, around] : shells_around) different.insert(around);
  EXPECT_EQ(different.size(), number);
}

TEST(Mesh_parts, are_told_by_the_innermost_shell_around)
{
  const Soup big = moved(meshes::cube(8), -1, -1, -1), cavity = moved(meshes::cube(4), 1, 1, 1);
  const Soup kernel = moved(meshes::cube(2), 2, 2, 2), far = moved(meshes::cube(3), 10, 0, 0);
  expect_parts({far}, 1);
  expect_parts({big, cavity}, 1);
  expect_parts({kernel, cavity, big}, 2);
  expect_parts({kernel.inverted(), far, cavity, big}, 3);
  expect_parts({meshes::sphere(2, 1), meshes::sphere(2, 1, Point(5, 0, 0))}, 2);
}

TEST(Mesh_parts, are_several_where_shells_touch_in_a_vertex_or_an_edge)
{
  expect_parts({meshes::cube(), moved(meshes::cube(), 1, 1, 1)}, 2);
  expect_parts({meshes::cube(), moved(meshes::cube(), 1, 1, 0)}, 2);
}

TEST(Mesh_parts, do_not_depend_on_the_scale)
{
  for(const double scale : {0x1p-60, 0x1p100})
    expect_parts({exact_surface::scaled(moved(meshes::cube(2), 2, 2, 2), scale),
                  exact_surface::scaled(moved(meshes::cube(4), 1, 1, 1), scale),
                  exact_surface::scaled(meshes::cube(8), scale)},
                 2);
}

TEST(Mesh_parts, are_known_to_meshes_only)
{
  static_assert(internal::Has_surface<Mesh_domain>::value);
  static_assert(!internal::Has_surface<Ball_domain_3<>>::value);
}

} // namespace test_mesh_parts
