// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/picture_option_texts.h"
#include "pictures/cuts.h"
#include "pictures/surface_paths.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

namespace test_cuts {

using namespace vfc;
namespace generators = CGAL::Volume_filling_curves::internal;

double length(const Drawn_curve& curve)
{
  double sum = 0;
  for(const Drawn_edge& edge : curve.edges)
    sum += (curve.points[edge.target] - curve.points[edge.source]).norm();
  return sum;
}

Drawn_curve drawn_knot()
{
  const Curve curve = generators::closed_network(generators::torus_knot(3, 4, 300));
  return {curve, Curve_view(curve), edge_values(curve, Coloring::ARCLENGTH)};
}

TEST(Cuts, leave_of_a_curve_what_is_in_the_half_space)
{
  const Drawn_curve whole = drawn_knot();
  const Half_space lower{Vector(0, 0.6, 0.8), 230}, upper{-lower.normal, -lower.offset};
  Drawn_curve below = whole, above = whole;
  cut(below, lower);
  cut(above, upper);
  EXPECT_NEAR(length(below) + length(above), length(whole), 1e-9 * length(whole));
  EXPECT_GT(length(below), 0.1 * length(whole));
  EXPECT_GT(length(above), 0.1 * length(whole));
  for(const Drawn_edge& edge : below.edges)
    for(const std::size_t v : {edge.source, edge.target})
      EXPECT_LE(lower.height(below.points[v]), 1e-9);
}

TEST(Cuts, make_open_strands_that_hang_together)
{
  Drawn_curve curve = drawn_knot();
  cut(curve, {Vector(0, 0.6, 0.8), 230});
  ASSERT_GT(curve.strands.size(), 1u);
  EXPECT_EQ(curve.ends.size(), 2 * curve.strands.size());
  std::size_t edges = 0;
  for(const Strand& strand : curve.strands) {
    EXPECT_FALSE(strand.is_closed);
    for(std::size_t i = 0; i + 1 < strand.edges.size(); ++i)
      EXPECT_EQ(curve.edges[strand.edges[i]].target, curve.edges[strand.edges[i + 1]].source);
    edges += strand.edges.size();
  }
  EXPECT_EQ(edges, curve.edges.size());
}

TEST(Cuts, keep_a_curve_that_they_miss)
{
  const Drawn_curve whole = drawn_knot();
  Drawn_curve all = whole, nothing = whole;
  cut(all, {Vector::UnitZ(), 1e6});
  cut(nothing, {Vector::UnitZ(), -1e6});
  EXPECT_EQ(all.edges.size(), whole.edges.size());
  ASSERT_EQ(all.strands.size(), 1u);
  EXPECT_TRUE(all.strands[0].is_closed);
  EXPECT_TRUE(nothing.edges.empty() && nothing.strands.empty() && nothing.ends.empty());
}

TEST(Cuts, interpolate_what_the_color_tells)
{
  Drawn_curve curve = drawn_knot();
  const double unit = (curve.points[1] - curve.points[0]).norm(); // of the picture, per value
  const double value = curve.edges[0].values[1] - curve.edges[0].values[0];
  cut(curve, {Vector(0, 0.6, 0.8), 230});
  for(const Drawn_edge& edge : curve.edges)
    EXPECT_NEAR((curve.points[edge.target] - curve.points[edge.source]).norm() / unit,
                (edge.values[1] - edge.values[0]) / value, 1e-9);
}

// An octahedron of volume 4/3, whose sections are known.
Triangle_soup octahedron()
{
  Triangle_soup soup;
  soup.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return soup;
}

TEST(Cuts, leave_of_a_surface_what_is_in_the_half_space_and_its_rim)
{
  const double height = 0.25;
  const Cut_surface result = cut(octahedron(), {Vector::UnitZ(), height});
  double area = 0;
  for(std::size_t t = 0; t < result.soup.triangles.size(); ++t) {
    area += result.soup.area_normal(t).norm() / 2;
    for(const std::size_t v : result.soup.triangles[t])
      EXPECT_LE(result.soup.points[v].z(), height);
  }
  const double half = 2 * std::sqrt(3); // of the octahedron
  EXPECT_NEAR(area, 2 * half - half * std::pow(1 - height, 2), 1e-12);
  ASSERT_EQ(result.rim.size(), 4u);
  double section = 0; // the rim runs as the faces above did: counterclockwise seen from above
  std::map<std::size_t, int> balance;
  for(const auto& [v, w] : result.rim) {
    section += result.soup.points[v].cross(result.soup.points[w]).z() / 2;
    ++balance[v];
    --balance[w];
  }
  EXPECT_NEAR(section, 2 * std::pow(1 - height, 2), 1e-12);
  for(const auto& [v, number] : balance) EXPECT_EQ(number, 0) << v;
  const std::string path = loops_path({{4, 5}, {5, 4}}, result.soup.points);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'Z'), 1);
}

TEST(Picture_option_texts, are_directions)
{
  EXPECT_LT((*parse_direction("1,-2,0.5") - Vector(1, -2, 0.5)).norm(), 1e-12);
  EXPECT_LT((*parse_direction("0,0") - Vector::UnitZ()).norm(), 1e-12);
  EXPECT_LT((*parse_direction("90,0") - Vector::UnitX()).norm(), 1e-12);
  EXPECT_LT((*parse_direction("17,90") - Vector::UnitY()).norm(), 1e-12);
  for(const std::string text :
      {"", "1", "0,0,0", "1,2,3,4", "1,2,", "a,b", "0,91", "1e200,0,0", "nan,1,1", "1 2 3"})
    EXPECT_FALSE(parse_direction(text)) << text;
}

TEST(Picture_option_texts, are_planes)
{
  const Plane plane = *parse_plane("y=-0.5");
  EXPECT_EQ(plane.normal, Vector::UnitY());
  EXPECT_EQ(plane.offset, -0.5);
  EXPECT_EQ(parse_plane("1,2,3,4")->normal, Vector(1, 2, 3));
  EXPECT_EQ(parse_plane("1,2,3,4")->offset, 4);
  for(const std::string text :
      {"", "x", "x=", "x=a", "w=1", "x=1,2", "1,2,3", "0,0,0,1", "1,2,3,4,5"})
    EXPECT_FALSE(parse_plane(text)) << text;
}

} // namespace test_cuts
