// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_crossings {

namespace vfc = CGAL::Volume_filling_curves;
namespace generators = CGAL::Volume_filling_curves::internal;
using generators::Polygons;
using generators::Vector;
using Curve = vfc::Curve_network_3<>;
using Point = Curve::Point_3;
using Matrix = std::vector<std::vector<int>>;

Curve closed(const Polygons& polygons)
{
  return generators::closed_network(polygons);
}

Curve braid(const std::string& word, std::size_t nodes)
{
  return vfc::make_closed_braid(vfc::parse_braid_word(word), nodes);
}

Vector position(const Curve& curve, std::size_t v)
{
  return generators::to_vector(curve.point(v));
}

// Twins: the same numbers by definition, in quadratic time.

// The solid angle that a segment sees of another one (Banchoff 1976; Klenin and Langowski 2000).
double gauss_integral(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  const std::array<Vector, 4> normals{(c - a).cross(d - a), (d - a).cross(d - b),
                                      (d - b).cross(c - b), (c - b).cross(c - a)};
  double angle = 0;
  for(std::size_t i = 0; i < 4; ++i) {
    const Vector u = normals[i].normalized(), v = normals[(i + 1) % 4].normalized();
    angle += std::asin(std::clamp(u.dot(v), -1., 1.));
  }
  const double sign = (b - a).cross(d - c).dot(a - c);
  return std::isnan(angle) || sign == 0 ? 0 : std::copysign(std::abs(angle), sign) / (4 * CGAL_PI);
}

double gauss_linking_number(const Curve& curve, std::size_t a, std::size_t b)
{
  double sum = 0;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    for(std::size_t f = 0; f < curve.number_of_edges(); ++f)
      if(curve.component(curve.source(e)) == a && curve.component(curve.source(f)) == b)
        sum += gauss_integral(position(curve, curve.source(e)), position(curve, curve.target(e)),
                              position(curve, curve.source(f)), position(curve, curve.target(f)));
  return sum;
}

double exact_average_crossing_number(const Curve& curve)
{
  double sum = 0;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    for(std::size_t f = 0; f < e; ++f)
      if(!generators::share_a_node(curve, e, f))
        sum += std::abs(
            gauss_integral(position(curve, curve.source(e)), position(curve, curve.target(e)),
                           position(curve, curve.source(f)), position(curve, curve.target(f))));
  return 2 * sum;
}

TEST(Average_crossing_number, of_convex_plane_curves_is_zero)
{
  Polygons circle(1);
  for(int i = 0; i < 50; ++i)
    circle[0].push_back({std::cos(CGAL_PI * i / 25), std::sin(CGAL_PI * i / 25), 0.5});
  EXPECT_EQ(vfc::average_crossing_number(closed(circle)), 0);
  EXPECT_EQ(vfc::average_crossing_number(Curve()), 0);
}

TEST(Average_crossing_number, is_that_of_the_gauss_integral_within_sampling_error)
{
  for(const Curve& curve :
      {closed(generators::torus_knot(2, 3, 60)), closed(generators::random_polygon(120, 3)),
       closed(generators::lattice_polygon(100, 2)), braid("1 1 -2 1 -2", 120)}) {
    const double expected = exact_average_crossing_number(curve);
    EXPECT_NEAR(vfc::average_crossing_number(curve), expected, 0.03 * expected);
  }
}

TEST(Average_crossing_number, of_a_knot_is_not_below_its_crossing_number)
{
  EXPECT_GE(vfc::average_crossing_number(closed(generators::torus_knot(2, 3, 100))), 3);
  EXPECT_GE(vfc::average_crossing_number(braid("1 -2 1 -2", 200)), 4);
}

// Products of lengths underflow; one cell for all edges would take quadratic time.
TEST(Average_crossing_number, does_not_depend_on_the_size)
{
  const Curve knot = vfc::make_torus_knot(2, 3, 3000);
  const double expected = vfc::average_crossing_number(knot);
  for(const int exponent : {-1040, -570, 400}) {
    std::vector<Point> points;
    for(std::size_t v = 0; v <= knot.number_of_nodes(); ++v) {
      const Vector x = std::ldexp(1., exponent) * position(knot, v % knot.number_of_nodes());
      points.emplace_back(x.x(), x.y(), x.z());
    }
    const double number = vfc::average_crossing_number(Curve(points));
    EXPECT_NEAR(number, expected, exponent < -1000 ? 0.1 : 0) << exponent; // rounded coordinates
  }
}

TEST(Average_crossing_number, is_the_same_in_parallel)
{
  for(const Curve& curve : {closed(generators::random_polygon(500, 1)), Curve()})
    EXPECT_EQ(vfc::average_crossing_number<CGAL::Parallel_if_available_tag>(curve),
              vfc::average_crossing_number(curve));
}

TEST(Linking_matrix, of_the_hopf_link_is_one_and_changes_sign_with_the_mirror)
{
  EXPECT_EQ(vfc::linking_matrix(braid("1 1", 60)), (Matrix{{0, 1}, {1, 0}}));
  EXPECT_EQ(vfc::linking_matrix(braid("-1 -1", 60)), (Matrix{{0, -1}, {-1, 0}}));
}

TEST(Linking_matrix, of_known_links)
{
  EXPECT_EQ(vfc::linking_matrix(braid("1 1 -2 1 -2", 120)), (Matrix{{0, 0}, {0, 0}}));
  EXPECT_EQ(vfc::linking_matrix(closed(generators::torus_knot(2, 8, 120)))[0][1], 4);
  EXPECT_EQ(vfc::linking_matrix(closed(generators::torus_knot(4, 6, 200)))[0][1], 6);
  EXPECT_EQ(vfc::linking_matrix(braid("1 1 2 2 2 2 -3 -3", 200)),
            (Matrix{{0, 1, 0, 0}, {1, 0, 2, 0}, {0, 2, 0, -1}, {0, 0, -1, 0}}));
}

TEST(Linking_matrix, is_right_for_squares_on_a_lattice)
{
  const Polygons squares{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                         {{1, 1, -1}, {3, 1, -1}, {3, 1, 1}, {1, 1, 1}}};
  const int number = vfc::linking_matrix(closed(squares))[0][1];
  EXPECT_EQ(std::abs(number), 1);
  EXPECT_NEAR(gauss_linking_number(closed(squares), 0, 1), number, 1e-9);
  const Polygons apart{squares[0], {{5, 1, -1}, {7, 1, -1}, {7, 1, 1}, {5, 1, 1}}};
  EXPECT_EQ(vfc::linking_matrix(closed(apart)), (Matrix{{0, 0}, {0, 0}}));
}

TEST(Linking_matrix, is_undefined_for_components_that_meet)
{
  const Curve meeting = closed({{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
                                {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
                                {{1, 0, -1}, {1, 0, 1}, {1, -1, 0}}});
  EXPECT_EQ(refusal_of([&] { (void)vfc::linking_matrix(meeting); }),
            "components 1 and 2 meet, and their linking number is undefined");
  EXPECT_THROW((void)vfc::measure(meeting), std::invalid_argument);
}

TEST(Linking_matrix, is_the_rounded_gauss_integral)
{
  for(std::uint64_t seed = 1; seed < 8; ++seed) {
    Polygons polygons;
    for(std::uint64_t k = 0; k < 3; ++k) {
      polygons.push_back(generators::random_polygon(60, 10 * seed + k)[0]);
      for(Vector& v : polygons.back()) v[0] += 0.3 * static_cast<double>(k);
    }
    const Curve curve = closed(polygons);
    const Matrix matrix = vfc::linking_matrix(curve);
    for(std::size_t a = 0; a < 3; ++a)
      for(std::size_t b = 0; b < a; ++b)
        EXPECT_NEAR(gauss_linking_number(curve, a, b), matrix[a][b], 1e-6);
  }
}

TEST(Linking_matrix, is_zero_for_paths)
{
  const Curve lines({Point(0, 0, 0), Point(4, 0, 0), Point(0, 0, 3), Point(4, 1, 3)},
                    {{0, 1}, {2, 3}});
  EXPECT_EQ(vfc::linking_matrix(lines), (Matrix{{0, 0}, {0, 0}}));
}

TEST(Linking_matrix, takes_exact_kernels)
{
  using Traits = vfc::Curve_flow_traits_3<CGAL::Exact_predicates_exact_constructions_kernel>;
  const auto curve = vfc::make_closed_braid<Traits>({1, 1}, 60);
  EXPECT_EQ(vfc::linking_matrix(curve)[0][1], 1);
}

} // namespace test_crossings
