// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Curve_view.h"
#include "pictures/Stroke_layers.h"
#include "pictures/curve_pictures.h"

#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace test_svg_pictures {

using namespace vfc;
namespace generators = CGAL::Volume_filling_curves::internal;
using generators::Polygons;
using Point = Curve::Point_3;

std::string svg_of(const Polygons& polygons)
{
  return svg_picture(generators::closed_network(polygons));
}

std::size_t count(const std::string& text, const std::string& word)
{
  std::size_t n = 0;
  for(std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1)) ++n;
  return n;
}

const std::vector<Polygons>& curves()
{
  static const std::vector<Polygons> all{
      generators::torus_knot(2, 3, 200), generators::braid_closure({1, 1, -2, 1, -2}, 200),
      generators::random_polygon(300, 1), generators::lattice_polygon(300, 1)};
  return all;
}

TEST(Svg_picture, writes_elements_that_are_closed_and_references_that_exist)
{
  for(const Polygons& polygons : curves()) {
    const std::string text = svg_of(polygons);
    EXPECT_EQ(text.compare(0, 4, "<svg"), 0);
    EXPECT_EQ(text.substr(text.size() - 7), "</svg>\n");
    EXPECT_EQ(count(text, "<g"), count(text, "</g>"));
    EXPECT_EQ(count(text, "<"), count(text, ">"));
    EXPECT_EQ(count(text, "nan") + count(text, "inf"), 0u);
    for(std::size_t i = text.find("href=\"#"); i != std::string::npos;
        i = text.find("href=\"#", i + 1)) {
      const std::string name = text.substr(i + 7, text.find('"', i + 7) - i - 7);
      EXPECT_NE(text.find("id=\"" + name + '"'), std::string::npos) << name;
    }
  }
}

TEST(Svg_picture, stays_inside_the_picture)
{
  for(const Polygons& polygons : curves()) {
    const Curve curve = generators::closed_network(polygons);
    const Curve_view view(curve);
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      for(int k : {0, 1}) {
        EXPECT_GT(view.point(v)[k], view.width());
        EXPECT_LT(view.point(v)[k], Curve_view::picture_size - view.width());
      }
  }
}

TEST(Svg_picture, does_not_depend_on_size_and_repeats)
{
  for(Polygons polygons : curves()) {
    const std::string text = svg_of(polygons);
    EXPECT_EQ(text, svg_of(polygons));
    for(auto& polygon : polygons)
      for(auto& v : polygon) v = 0x1p-50 * v;
    EXPECT_EQ(text, svg_of(polygons));
  }
}

// The view is a rotation: a mirror image would be a lie.
TEST(Svg_picture, does_not_mirror_the_curve)
{
  for(const Polygons& polygons : curves()) {
    const Curve curve = generators::closed_network(polygons);
    const Curve_view view(curve);
    const auto volume = [&](const auto& point) {
      return (point(10) - point(0)).cross(point(25) - point(0)).dot(point(40) - point(0));
    };
    const double before = volume([&](std::size_t v) { return to_vector(curve.point(v)); });
    const double after = volume([&](std::size_t v) -> Vector {
      const Vector& p = view.point(v);
      return {p.x(), -p.y(), p.z()}; // y points downwards in the picture
    });
    EXPECT_GT(before * after, 0);
  }
}

// Layers by definition, for all pairs of pieces that cross in the picture.
TEST(Stroke_layers, put_the_upper_strand_into_the_higher_layer)
{
  for(const Polygons& polygons : curves()) {
    const Curve curve = generators::closed_network(polygons);
    const Curve_view view(curve);
    const Drawn_curve drawn(curve, view, edge_values(curve, Coloring::COMPONENT));
    const Stroke_layers layers(drawn);
    const auto& pieces = layers.pieces();
    int crossings = 0, wrong = 0;
    for(std::size_t i = 0; i < pieces.size(); ++i)
      for(std::size_t j = 0; j < i; ++j) {
        const auto &a = pieces[i], &b = pieces[j];
        // next to each other along the curve strokes may overlap in one layer
        if(a.strand == b.strand && (a.source - b.source).norm() < 5 * view.width()) continue;
        const Vector u = a.target - a.source, v = b.target - b.source, w = b.source - a.source;
        const double area = u.x() * v.y() - u.y() * v.x();
        const double s = (w.x() * v.y() - w.y() * v.x()) / area;
        const double t = (w.x() * u.y() - w.y() * u.x()) / area;
        if(!(s > 0 && s < 1 && t > 0 && t < 1)) continue;
        ++crossings;
        const double height = s * u.z() - w.z() - t * v.z();
        if((height > 0) != (a.layer > b.layer) || a.layer == b.layer) ++wrong;
      }
    EXPECT_GT(crossings, 2);
    EXPECT_EQ(wrong, 0);
  }
}

TEST(Svg_picture, draws_components_in_their_own_colors_and_ends_as_dots)
{
  const Curve arc({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0)}, {{0, 1}, {1, 2}});
  EXPECT_EQ(count(svg_picture(arc), "h0"), 2u);
  EXPECT_EQ(count(svg_of(curves()[0]), "h0"), 0u);
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

TEST(Svg_picture, draws_networks_without_gaps_but_where_they_cross)
{
  EXPECT_EQ(number_of_gaps(star({{1, 0, 0}, {-1, 1, 0.1}, {-1, -1, -0.1}})), 0u);
  EXPECT_EQ(number_of_gaps(star({{1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}, {-1, -1, 0}})), 0u);
  const std::vector<Point> points{Point(0, 0, 0),   Point(9, 0, 0),  Point(13, 3, 0),
                                  Point(13, -3, 0), Point(4, -4, 1), Point(4, 4, 1)};
  const std::vector<std::array<std::size_t, 2>> fork{{0, 1}, {1, 2}, {1, 3}};
  EXPECT_EQ(number_of_gaps(Curve(points, fork)), 0u);
  EXPECT_EQ(number_of_gaps(Curve(points, {{0, 1}, {1, 2}, {1, 3}, {4, 5}})), 1u);
}

// Edges of opposite directions end a strand, too, but leave no gap.
TEST(Svg_picture, draws_edges_of_any_direction_in_one_stroke)
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
        if(i > 0) EXPECT_EQ(curve->target(strand.edges[i - 1]), curve->source(strand.edges[i]));
      }
    EXPECT_EQ(visits, std::vector<int>(curve->number_of_edges(), 1));
  }
}

TEST(Svg_picture, has_a_scale_with_numbers_and_units)
{
  const Curve curve = generators::closed_network(curves()[0]);
  Picture_options options;
  EXPECT_EQ(count(svg_picture(curve, Mesh(), options), "<text"), 0u);
  const std::vector<std::array<std::string, 2>> titles{{"arclength", "in units"},
                                                       {"radius", "in units"},
                                                       {"curvature", "per unit"},
                                                       {"thickness", "in units"}};
  std::size_t k = 0;
  for(const auto coloring :
      {Coloring::ARCLENGTH, Coloring::RADIUS, Coloring::CURVATURE, Coloring::THICKNESS}) {
    options.coloring = coloring;
    const std::string text = svg_picture(curve, Mesh(), options);
    for(const std::string& word : titles[k++]) EXPECT_EQ(count(text, '>' + word + '<'), 1u) << word;
    EXPECT_GE(count(text, "<text"), 2u + 3u) << "numbers";
  }
}

TEST(Svg_picture, labels_nodes_with_their_numbers)
{
  const Curve square({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)},
                     {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  Picture_options options;
  options.has_labels = true;
  const std::string all = svg_picture(square, Mesh(), options);
  for(const std::string number : {"1", "2", "3", "4"})
    EXPECT_EQ(count(all, '>' + number + '<'), 1u);
  options.cut = Plane{Vector::UnitX(), 0.5};
  options.direction = Vector(1, 0, 1); // the side of large x is the viewer's
  const std::string rest = svg_picture(square, Mesh(), options);
  EXPECT_EQ(count(rest, ">1<") + count(rest, ">4<"), 2u);
  EXPECT_EQ(count(rest, ">2<") + count(rest, ">3<"), 0u);
}

// Where the axes point in the picture.
TEST(Curve_view, is_from_the_direction_that_is_asked_for)
{
  const Curve axes({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
                   {{0, 1}, {0, 2}, {0, 3}});
  std::array<std::size_t, 4> node;
  for(std::size_t v = 0; v < 4; ++v) node[axes.origin(v)] = v;
  const auto place = [&](const Vector& direction, std::size_t k) -> Vector {
    const Curve_view view(axes, Triangle_soup(), {direction, false});
    return (view.point(node[k]) - view.point(node[0])).normalized();
  };
  EXPECT_LT((place({0, 0, 2}, 1) - Vector(1, 0, 0)).norm(), 1e-12) << "x to the right";
  EXPECT_LT((place({0, 0, 2}, 2) - Vector(0, -1, 0)).norm(), 1e-12)
      << "y up, where rows count down";
  EXPECT_LT((place({3, 0, 0}, 3) - Vector(-1, 0, 0)).norm(), 1e-12) << "z to the left";
  EXPECT_LT((place({0, 1, 0}, 2) - Vector(0, 0, 1)).norm(), 1e-12) << "y to the viewer";
  EXPECT_LT((place({0, 1, 0}, 3) - Vector(0, 1, 0)).norm(), 1e-12) << "z down";
}

TEST(Svg_picture, takes_whatever_a_network_can_be)
{
  EXPECT_FALSE(svg_picture(Curve()).empty());
  const Curve star({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
                   {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_EQ(count(svg_picture(star), "nan"), 0u);
  const Curve point({Point(1, 1, 1), Point(1, 1, 1)}, {{0, 1}});
  EXPECT_EQ(count(svg_picture(point), "nan"), 0u);
  const Curve line({Point(0, 0, 0), Point(0, 0, 1)}, {{0, 1}});
  EXPECT_EQ(count(svg_picture(line), "nan"), 0u);
}

} // namespace test_svg_pictures
