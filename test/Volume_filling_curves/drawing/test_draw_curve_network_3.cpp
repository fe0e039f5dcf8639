// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// A curve in a scene of CGAL 6; CGAL 5 has no scene without a window.

#include <CGAL/Volume_filling_curves/draw_curve_network_3.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace test_draw_curve_network_3 {

#ifdef CGAL_VOLUME_FILLING_CURVES_HAS_GRAPHICS_SCENE

using CGAL::Graphics_scene;
using Color = std::array<float, 3>;

// The colors of a buffer, which holds three numbers for each point.
std::vector<Color> colors(const Graphics_scene& scene, int buffer)
{
  const std::vector<float>& numbers = scene.get_array_of_index(buffer);
  std::vector<Color> result;
  for(std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    result.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return result;
}

TEST(Draw_curve_network_3, a_scene_gets_nodes_and_edges_in_the_colors_of_components)
{
  auto link = CGAL::Volume_filling_curves::make_torus_knot(2, 4, 80);
  link.set_pinned(0);
  Graphics_scene scene;
  CGAL::add_to_graphics_scene(link, scene);
  EXPECT_EQ(scene.number_of_elements(Graphics_scene::POS_COLORED_POINTS), 80u);
  EXPECT_EQ(scene.number_of_elements(Graphics_scene::POS_COLORED_SEGMENTS), 2 * 80u);
  EXPECT_EQ(scene.bounding_box(), link.bbox());
  const std::vector<Color> of_edges = colors(scene, Graphics_scene::COLOR_SEGMENTS);
  const std::vector<Color> of_nodes = colors(scene, Graphics_scene::COLOR_POINTS);
  EXPECT_EQ(std::set<Color>(of_edges.begin(), of_edges.end()).size(), 2u);
  ASSERT_EQ(of_nodes.size(), 80u);
  EXPECT_EQ(of_nodes[0], (Color{0, 0, 0})) << "a pinned node";
  for(std::size_t v = 1; v < 80; ++v)
    EXPECT_EQ(of_nodes[v], of_edges[link.component(v) == 0 ? 0 : 159]) << v;
}

#endif

} // namespace test_draw_curve_network_3
