// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Curve_view.h"
#include "pictures/Stroke_layers.h"
#include "pictures/Tube_colors.h"
#include "pictures/curve_pictures.h"

#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
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

Picture_options colored(Coloring coloring)
{
  Picture_options options;
  options.coloring = coloring;
  return options;
}

// The paths of white strokes, each of which begins with an M.
std::size_t number_of_gaps(const std::string& text)
{
  std::size_t n = 0;
  const std::string begin = "<path stroke=\"#fff\"";
  for(std::size_t i = text.find(begin); i != std::string::npos; i = text.find(begin, i + 1))
    n += count(text.substr(i, text.find("/>", i) - i), "M");
  return n;
}

// A gap that began anew with each color made 65 of them.
TEST(Svg_picture, has_whole_gaps_at_three_crossings_however_many_colors_there_are)
{
  const Curve trefoil = generators::closed_network(generators::torus_knot(2, 3, 200));
  for(const Coloring coloring : {Coloring::COMPONENT, Coloring::ARCLENGTH, Coloring::CURVATURE,
                                 Coloring::RADIUS, Coloring::THICKNESS}) {
    const std::size_t gaps = number_of_gaps(svg_picture(trefoil, Mesh(), colored(coloring)));
    EXPECT_GE(gaps, 3u);
    EXPECT_LE(gaps, 12u); // a strand may pass over another one in several layers
  }
}

TEST(Stroke_layers, have_pieces_whose_colors_are_next_to_each_other)
{
  const Curve curve = generators::closed_network(generators::lattice_polygon(30, 1));
  const Edge_values values = edge_values(curve, Coloring::ARCLENGTH);
  const Tube_colors colors(Coloring::ARCLENGTH, values);
  const Drawn_curve drawn(curve, Curve_view(curve), values);
  const Stroke_layers layers(drawn, colors.level_step());
  std::size_t changes = 0;
  for(const Stroke_piece& piece : layers.pieces()) {
    if(&piece == &layers.pieces().back()) continue; // there the length begins anew
    const std::size_t level = colors.level(piece.value);
    const std::size_t next = colors.level(layers.pieces()[piece.next].value);
    changes += next != level;
    EXPECT_LE(next, level + 1);
    EXPECT_LE(level, next + 1);
  }
  EXPECT_GT(changes, 40u);
}

TEST(Curve_view, fills_the_picture_with_what_a_cut_leaves)
{
  const Curve line({Point(0, 0, 0), Point(4, 0, 0), Point(4, 1, 0), Point(0, 1, 0)},
                   {{0, 1}, {1, 2}, {2, 3}});
  const Vector front(0, 0, 1);
  const Curve_view whole(line, Triangle_soup(), {front});
  const Curve_view cut(line, Triangle_soup(), {front, false, Plane{Vector(2, 0, 0), 2}});
  const double margin = whole.place(Vector(0, 0, 0)).x();
  EXPECT_NEAR(whole.place(Vector(4, 0, 0)).x(), 800 - margin, 1e-9);
  EXPECT_NEAR(cut.place(Vector(0, 0, 0)).x(), margin, 1e-9);
  EXPECT_NEAR(cut.place(Vector(1, 0, 0)).x(), 800 - margin, 1e-9);
}

TEST(Curve_view, draws_a_tube_as_thick_as_it_is_and_has_room_for_it)
{
  const Curve line({Point(0, 0, 0), Point(4, 0, 0)}, {{0, 1}});
  const Curve_view view(line, Triangle_soup(), {Vector(0, 0, 1), false, std::nullopt, 0.5});
  const Vector a = view.place(Vector(0, 0, 0)), b = view.place(Vector(4, 0, 0));
  EXPECT_NEAR(view.width(), (b - a).norm() / 4, 1e-9);
  EXPECT_GT(a.x(), view.width() / 2);
  EXPECT_LT(b.x(), Curve_view::picture_size - view.width() / 2);
}

TEST(Curve_view, fits_a_picture_that_is_wider_than_high)
{
  const Curve line({Point(0, 0, 0), Point(4, 0, 0), Point(4, 2, 0)}, {{0, 1}, {1, 2}});
  const Curve_view view(line, Triangle_soup(),
                        {Vector(0, 0, 1), false, std::nullopt, 0, {1600, 800}});
  EXPECT_GT(view.place(Vector(4, 0, 0)).x() - view.place(Vector(0, 0, 0)).x(), 1400);
  EXPECT_NEAR(view.place(Vector(2, 1, 0)).x(), 800, 1e-9);
  EXPECT_NEAR(view.place(Vector(2, 1, 0)).y(), 400, 1e-9);
}

TEST(Svg_picture, draws_components_in_their_own_colors_and_ends_as_dots)
{
  const Curve arc({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0)}, {{0, 1}, {1, 2}});
  EXPECT_EQ(count(svg_picture(arc), "h0"), 2u);
  EXPECT_EQ(count(svg_of(curves()[0]), "h0"), 0u);
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

TEST(Svg_picture, labels_the_nearer_of_two_nodes_at_one_place)
{
  const Curve curve({Point(0, 0, 0), Point(5, 0, 0), Point(0, 5, 0), Point(0, 0, 2)},
                    {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  Picture_options options;
  options.has_labels = true;
  options.direction = Vector(0, 0, 1);
  const std::string front = svg_picture(curve, Mesh(), options);
  EXPECT_EQ(count(front, ">4<"), 1u);
  EXPECT_EQ(count(front, ">1<"), 0u);
  options.direction = Vector(0, 0, -1);
  const std::string back = svg_picture(curve, Mesh(), options);
  EXPECT_EQ(count(back, ">1<"), 1u);
  EXPECT_EQ(count(back, ">4<"), 0u);
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
