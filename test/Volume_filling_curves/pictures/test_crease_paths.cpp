// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/curve_pictures.h"
#include "pictures/surface_paths.h"

#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace test_crease_paths {

using namespace vfc;

// A prism along the z-axis, whose caps are fans around their centers.
Triangle_soup prism(std::size_t sides)
{
  Triangle_soup soup;
  for(const double z : {0.0, 1.0}) {
    soup.points.push_back({0, 0, z});
    for(std::size_t k = 0; k < sides; ++k) {
      const double turn = 2 * CGAL_PI * static_cast<double>(k) / static_cast<double>(sides);
      soup.points.push_back({std::cos(turn), std::sin(turn), z});
    }
  }
  const std::size_t top = sides + 1;
  for(std::size_t k = 0; k < sides; ++k) {
    const std::size_t a = 1 + k, b = 1 + (k + 1) % sides;
    soup.triangles.push_back({0, b, a});
    soup.triangles.push_back({top, top + a, top + b});
    soup.triangles.push_back({a, b, top + b});
    soup.triangles.push_back({a, top + b, top + a});
  }
  return soup;
}

// Oblique to all edges and faces.
void turn(Triangle_soup& soup)
{
  const Eigen::AngleAxisd rotation(0.7, Vector(1, 2, 0.5).normalized());
  for(Vector& p : soup.points) p = rotation * p;
}

std::size_t lines(const std::string& path)
{
  return static_cast<std::size_t>(std::count(path.begin(), path.end(), 'M'));
}

// Of a cube's twelve edges six are its outline, and three meet at the corner next to the viewer.
TEST(Crease_paths, are_the_edges_of_a_cube_but_for_its_outline)
{
  Triangle_soup cube = prism(4);
  turn(cube);
  EXPECT_EQ(lines(crease_paths(cube).front), 3u);
  EXPECT_EQ(lines(crease_paths(cube).back), 3u);
}

TEST(Crease_paths, change_sides_with_the_viewer)
{
  Triangle_soup wedge = prism(3);
  turn(wedge);
  const Crease_paths before = crease_paths(wedge);
  EXPECT_NE(lines(before.front), lines(before.back));
  const Eigen::AngleAxisd half_turn(CGAL_PI, Vector::UnitY());
  for(Vector& p : wedge.points) p = half_turn * p;
  const Crease_paths after = crease_paths(wedge);
  EXPECT_EQ(lines(after.front), lines(before.back));
  EXPECT_EQ(lines(after.back), lines(before.front));
}

// Along the axis of a round prism only the rims are creases.
TEST(Crease_paths, are_none_where_a_surface_is_round)
{
  constexpr std::size_t sides = 40;
  Triangle_soup cylinder = prism(sides);
  turn(cylinder);
  const Crease_paths paths = crease_paths(cylinder);
  EXPECT_GT(lines(paths.front), 0u);
  EXPECT_LE(lines(paths.front) + lines(paths.back), 2 * sides);
}

// Three faces of a tetrahedron meet at the viewer's corner, and the fourth is behind.
TEST(Crease_paths, are_in_svg_pictures)
{
  using Point = Curve::Point_3;
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0), Point(1, 1, 1), mesh);
  const Curve curve({Point(1, 1, 0.1), Point(1.1, 1, 0.1)}, {{0, 1}});
  Picture_options options;
  options.direction = Vector(0, 0, 1);
  const std::string path = crease_paths(Triangle_soup(mesh)).back; // z points to the viewer there
  EXPECT_EQ(lines(path), 3u);
  const std::string text = svg_picture(curve, mesh, options);
  const std::size_t front = text.find("stroke=\"#7d93ad\"");
  ASSERT_NE(front, std::string::npos);
  EXPECT_EQ(lines(text.substr(front, text.find("/>", front) - front)), 3u);
  EXPECT_EQ(text.find("stroke=\"#cbd6e2\""), std::string::npos);
}

TEST(Crease_paths, are_left_out_where_they_would_hide_the_curve)
{
  Triangle_soup many;
  for(std::size_t k = 0; k < 100; ++k) {
    Triangle_soup cube = prism(4);
    turn(cube);
    const std::size_t first = many.points.size();
    many.points.insert(many.points.end(), cube.points.begin(), cube.points.end());
    for(const auto& [a, b, c] : cube.triangles)
      many.triangles.push_back({first + a, first + b, first + c});
  }
  const Crease_paths paths = crease_paths(many);
  EXPECT_TRUE(paths.front.empty());
  EXPECT_TRUE(paths.back.empty());
}

} // namespace test_crease_paths
