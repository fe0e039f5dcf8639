// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/curve_pictures.h"
#include "pictures/strands.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Curves with junctions as SVG.
namespace test_network_pictures {

using namespace vfc;
using Point = Curve::Point_3;

std::size_t count(const std::string& text, const std::string& word)
{
  std::size_t n = 0;
  for(std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1)) ++n;
  return n;
}

// Arms of many edges from a common node, in these directions, each of them of length 1.
Curve star(const std::vector<Vector>& arms)
{
  constexpr std::size_t edges_per_arm = 20;
  std::vector<Point> points{Point(0, 0, 0)};
  std::vector<std::array<std::size_t, 2>> edges;
  for(const Vector& arm : arms)
    for(std::size_t i = 1; i <= edges_per_arm; ++i) {
      const Vector p = static_cast<double>(i) / edges_per_arm * arm.normalized();
      edges.push_back({i == 1 ? 0 : points.size() - 1, points.size()});
      points.emplace_back(p.x(), p.y(), p.z());
    }
  return Curve(points, edges);
}

std::size_t number_of_gaps(const Curve& curve)
{
  return count(svg_picture(curve), "<path stroke=\"#fff\"");
}

TEST(Picture_of_network, has_gaps_only_where_strands_cross)
{
  EXPECT_EQ(number_of_gaps(star({{1, 0, 0}, {-1, 1, 0.1}, {-1, -1, -0.1}})), 0u);
  EXPECT_EQ(number_of_gaps(star({{1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}, {-1, -1, 0}})), 0u);
  const std::vector<Point> points{Point(0, 0, 0),   Point(9, 0, 0),  Point(13, 3, 0),
                                  Point(13, -3, 0), Point(4, -4, 1), Point(4, 4, 1)};
  const std::vector<std::array<std::size_t, 2>> fork{{0, 1}, {1, 2}, {1, 3}};
  EXPECT_EQ(number_of_gaps(Curve(points, fork)), 0u);
  EXPECT_EQ(number_of_gaps(Curve(points, {{0, 1}, {1, 2}, {1, 3}, {4, 5}})), 1u);
}

TEST(Picture_of_network, has_no_gaps_between_edges_of_opposite_directions)
{
  const Curve zigzag(
      {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0.5, 0), Point(3, 0, 1), Point(1, -2, 0)},
      {{0, 1}, {2, 1}, {2, 3}, {1, 4}});
  EXPECT_EQ(number_of_gaps(zigzag), 0u);
  EXPECT_EQ(count(svg_picture(zigzag), "h0"), 4u);
}

TEST(Strands, are_paths_that_hold_every_edge_once)
{
  const Curve network = star({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Curve theta(
      {Point(0, 0, 0), Point(1, 1, 0), Point(1, 0, 0), Point(1, -1, 0), Point(2, 0, 0)},
      {{0, 1}, {1, 4}, {0, 2}, {2, 4}, {4, 3}, {3, 0}});
  const Curve lollipop({Point(0, 0, 0), Point(1, 0, 0), Point(2, 1, 0), Point(2, -1, 0)},
                       {{0, 1}, {1, 2}, {2, 3}, {3, 1}});
  const std::vector<std::size_t> expected{3, 3, 2};
  std::size_t k = 0;
  for(const Curve* const curve : {&network, &theta, &lollipop}) {
    const std::vector<Strand> strands = strands_of(*curve);
    EXPECT_EQ(strands.size(), expected[k++]);
    std::vector<int> visits(curve->number_of_edges(), 0);
    for(const Strand& strand : strands)
      for(std::size_t i = 0; i < strand.edges.size(); ++i) {
        ++visits[strand.edges[i]];
        if(i > 0) {
          EXPECT_EQ(curve->target(strand.edges[i - 1]), curve->source(strand.edges[i]));
        }
      }
    EXPECT_EQ(visits, std::vector<int>(curve->number_of_edges(), 1));
  }
}

} // namespace test_network_pictures
