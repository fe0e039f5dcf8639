// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_curve_measures {

namespace vfc = CGAL::Volume_filling_curves;
namespace generators = CGAL::Volume_filling_curves::internal;
using generators::Polygons;
using generators::Vector;
using Curve = vfc::Curve_network_3<>;
using Point = Curve::Point_3;
using Edges = std::vector<std::array<std::size_t, 2>>;

constexpr double pi = CGAL_PI;
constexpr double infinity = std::numeric_limits<double>::infinity();

Curve closed(const Polygons& polygons)
{
  return generators::closed_network(polygons);
}

Curve regular_polygon(int n, double radius)
{
  Polygons polygon(1);
  for(int i = 0; i < n; ++i)
    polygon[0].push_back(
        {radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 0.5});
  return closed(polygon);
}

Curve path(const std::vector<Point>& points)
{
  Edges edges;
  for(std::size_t i = 1; i < points.size(); ++i) edges.push_back({i - 1, i});
  return Curve(points, edges);
}

Polygons scaled(Polygons polygons, double factor)
{
  for(auto& polygon : polygons)
    for(Vector& v : polygon) v = factor * v;
  return polygons;
}

Vector position(const Curve& curve, std::size_t v)
{
  return generators::to_vector(curve.point(v));
}

// A twin: the same number by definition, in quadratic time.
double clearance_by_definition(const Curve& curve, double r)
{
  const generators::Least_clearance<Curve> neighborhood(curve, pi * r);
  double least = infinity;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    for(std::size_t f = e + 1; f < curve.number_of_edges(); ++f)
      if(!neighborhood.are_neighbors(e, f))
        least = (std::min)(
            least, std::sqrt(generators::squared_segment_distance(
                       position(curve, curve.source(e)), position(curve, curve.target(e)),
                       position(curve, curve.source(f)), position(curve, curve.target(f)))));
  return least;
}

Curve braid(const std::string& word, std::size_t nodes)
{
  return closed(generators::braid_closure(vfc::parse_braid_word(word), nodes, 0));
}

TEST(Length, is_the_total_length_and_of_components)
{
  const Curve curve({Point(0, 0, 0), Point(3, 4, 0), Point(9, 0, 0), Point(9, 0, 2)},
                    {{0, 1}, {2, 3}});
  EXPECT_EQ(vfc::component_lengths(curve), (std::vector<double>{5, 2}));
  EXPECT_EQ(vfc::length(curve), 7);
  EXPECT_EQ(vfc::length(Curve()), 0);
}

TEST(Total_curvature, of_a_plane_convex_polygon_is_two_pi)
{
  for(int n : {3, 4, 7, 100, 10001})
    EXPECT_NEAR(vfc::total_curvatures(regular_polygon(n, 2))[0], 2 * pi, 1e-11);
}

// A square's corners touch its inscribed circle; ends and junctions have none.
TEST(Node_curvatures, are_reciprocals_of_bend_radii)
{
  for(const double curvature : vfc::node_curvatures(regular_polygon(4, std::sqrt(2.))))
    EXPECT_NEAR(curvature, 1, 1e-12);
  const Curve arc = path({Point(0, 0, 0), Point(2, 0, 0), Point(2, 2, 0), Point(2, 3, 0)});
  const std::vector<double> expected{0, 1, 0, 0};
  const std::vector<double> curvatures = vfc::node_curvatures(arc);
  ASSERT_EQ(curvatures.size(), expected.size());
  for(std::size_t v = 0; v < 4; ++v) EXPECT_NEAR(curvatures[v], expected[v], 1e-12) << v;
}

TEST(Total_curvature, of_a_path_leaves_its_ends_out)
{
  const Curve corner = path({Point(0, 0, 0), Point(1, 0, 0), Point(1, 5, 0)});
  EXPECT_DOUBLE_EQ(vfc::total_curvatures(corner)[0], pi / 2);
  EXPECT_EQ(vfc::total_curvatures(path({Point(0, 0, 0), Point(1, 1, 1)}))[0], 0);
}

TEST(Total_curvature, of_a_spike_is_pi)
{
  const Curve spike = path({Point(0, 0, 0), Point(1, 2, 3), Point(0, 0, 0)});
  EXPECT_DOUBLE_EQ(vfc::total_curvatures(spike)[0], pi);
}

TEST(Total_curvature, of_a_component_with_junctions_is_not_a_number)
{
  const Curve star({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
                   {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_TRUE(std::isnan(vfc::total_curvatures(star)[0]));
  EXPECT_TRUE(std::isnan(vfc::ropelength(star)));
  EXPECT_EQ(vfc::component_lengths(star)[0], 3);
}

TEST(Total_curvature, of_a_knot_exceeds_four_pi)
{
  EXPECT_GT(vfc::total_curvatures(closed(generators::torus_knot(2, 3, 60)))[0], 4 * pi);
}

TEST(Bend_radius, of_a_regular_polygon_is_that_of_its_inscribed_circle)
{
  for(int n : {3, 4, 5, 64}) {
    EXPECT_NEAR(vfc::min_bend_radius(regular_polygon(n, 3)), 3 * std::cos(pi / n), 1e-12);
    EXPECT_NEAR(vfc::max_curvature(regular_polygon(n, 3)), 1 / (3 * std::cos(pi / n)), 1e-12);
  }
}

TEST(Bend_radius, of_a_straight_path_is_infinite_and_of_a_spike_zero)
{
  const Curve line = path({Point(0, 0, 0), Point(1, 2, 3), Point(2, 4, 6)});
  EXPECT_EQ(vfc::min_bend_radius(line), infinity);
  EXPECT_EQ(vfc::max_curvature(line), 0);
  const Curve spike = path({Point(0, 0, 0), Point(1, 0, 0), Point(0, 0, 0)});
  EXPECT_NEAR(vfc::min_bend_radius(spike), 0, 1e-15);
}

TEST(Ropelength, of_a_circle_is_two_pi)
{
  EXPECT_NEAR(vfc::ropelength(regular_polygon(100000, 5)), 2 * pi, 1e-6);
  EXPECT_NEAR(vfc::polygonal_thickness(regular_polygon(6, 2)), std::sqrt(3.), 1e-12);
}

TEST(Ropelength, of_two_clasped_circles_is_eight_pi)
{
  // each runs through the other one's center: the tight Hopf link, of thickness 1/2
  Polygons hopf(2);
  constexpr int n = 2000;
  for(int i = 0; i < n; ++i) {
    const double c = std::cos(2 * pi * i / n), s = std::sin(2 * pi * i / n);
    hopf[0].push_back({c, s, 0});
    hopf[1].push_back({1 + c, 0, s});
  }
  EXPECT_NEAR(vfc::polygonal_thickness(closed(hopf)), 0.5, 1e-5);
  EXPECT_NEAR(vfc::ropelength(closed(hopf)), 8 * pi, 1e-3);
}

TEST(Polygonal_thickness, of_a_long_loop_is_half_its_width)
{
  Polygons stadium(1);
  for(int i = 0; i <= 100; ++i)
    stadium[0].push_back({std::sin(pi * i / 100), -std::cos(pi * i / 100), 0});
  for(int i = 0; i <= 100; ++i)
    stadium[0].push_back({-9 - std::sin(pi * i / 100), std::cos(pi * i / 100), 0});
  EXPECT_NEAR(vfc::polygonal_thickness(closed(stadium)), 1, 1e-3);
  for(Vector& v : stadium[0]) v[1] *= std::abs(v.x() + 4.5) > 4.6 ? 1 : 0.5; // flatten the sides
  EXPECT_LT(vfc::polygonal_thickness(closed(stadium)), 0.6);
}

TEST(Polygonal_thickness, sees_where_a_wide_loop_is_pinched)
{
  Polygons peanut(1);
  constexpr int n = 4000;
  for(int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n;
    peanut[0].push_back({10 * std::cos(t), (1 + 9 * std::cos(t) * std::cos(t)) * std::sin(t), 0});
  }
  EXPECT_LT(vfc::polygonal_thickness(closed(peanut)), 1 + 1e-9);
}

TEST(Polygonal_thickness, of_paths_counts_their_ends)
{
  EXPECT_EQ(vfc::polygonal_thickness(path({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)})),
            infinity);
  const Curve lines({Point(0, 0, 0), Point(4, 0, 0), Point(5, 0, 0), Point(9, 0, 0)},
                    {{0, 1}, {2, 3}});
  EXPECT_EQ(vfc::polygonal_thickness(lines), 0.5);
}

TEST(Min_clearance, leaves_out_segments_that_share_a_node)
{
  EXPECT_EQ(vfc::min_clearance(regular_polygon(3, 1)), infinity);
  const Curve square = closed({{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}});
  EXPECT_EQ(vfc::min_clearance(square), 1);
  EXPECT_EQ(vfc::min_clearance(Curve()), infinity);
}

TEST(Min_clearance, leaves_out_less_than_pi_r_along_a_component)
{
  const Curve hairpin =
      path({Point(0, 0, 0), Point(10, 0, 0), Point(10, 1, 0), Point(10, 2, 0), Point(0, 3, 0)});
  EXPECT_EQ(vfc::min_clearance(hairpin), 1);
  EXPECT_EQ(vfc::min_clearance(hairpin, 1.9 / pi), 2);
  EXPECT_EQ(vfc::min_clearance(hairpin, 2.1 / pi), infinity);
  for(const double bad : {-1., std::nan("")})
    EXPECT_THROW((void)vfc::min_clearance(hairpin, bad), std::invalid_argument) << bad;
}

TEST(Min_clearance, of_components_counts_whatever_r_is)
{
  const Curve lines({Point(0, 0, 0), Point(4, 0, 0), Point(0, 0, 3), Point(4, 1, 3)},
                    {{0, 1}, {2, 3}});
  EXPECT_EQ(vfc::min_clearance(lines, 100), 3);
}

TEST(Min_clearance, goes_the_shorter_way_through_a_network)
{
  // two long strands, bridged at one place
  const std::vector<Point> points{Point(0, 0, 0), Point(5, 0, 0), Point(6, 0, 0), Point(20, 0, 0),
                                  Point(0, 3, 0), Point(5, 1, 0), Point(6, 2, 0), Point(20, 3, 0)};
  const Curve ladder(points, {{0, 1}, {1, 2}, {2, 3}, {4, 5}, {5, 6}, {6, 7}, {1, 5}});
  EXPECT_EQ(vfc::min_clearance(ladder), 1);
  EXPECT_DOUBLE_EQ(vfc::min_clearance(ladder, 1.5 / pi), std::sqrt(2.));
  for(double r : {0., 0.2, 0.4, 0.6, 0.8, 10.})
    EXPECT_EQ(vfc::min_clearance(ladder, r), clearance_by_definition(ladder, r));
}

TEST(Min_clearance, is_the_same_by_definition)
{
  for(std::uint64_t seed = 1; seed < 6; ++seed)
    for(double r : {0., 0.5, 2., 20.}) {
      const Curve curve = closed(generators::random_polygon(200 + seed, seed));
      EXPECT_EQ(vfc::min_clearance(curve, r), clearance_by_definition(curve, r));
    }
  const Curve link = braid("1 1 -2 1 -2 3 3", 150);
  for(double r : {0., 0.5, 2.})
    EXPECT_EQ(vfc::min_clearance(link, r), clearance_by_definition(link, r));
}

TEST(Curve_measures, scale_with_the_curve)
{
  const Polygons link = generators::braid_closure({1, 1, -2, 1, -2}, 150, 5);
  const auto small = vfc::measure(closed(link), 0.25);
  for(int exponent : {-480, -220, -40, 1, 60, 220, 480}) {
    const double factor = std::ldexp(1., exponent);
    const auto big = vfc::measure(closed(scaled(link, factor)), 0.25 * factor);
    EXPECT_EQ(big.length, factor * small.length);
    EXPECT_EQ(big.total_curvatures, small.total_curvatures);
    EXPECT_EQ(big.max_curvature, small.max_curvature / factor);
    EXPECT_EQ(big.polygonal_thickness, factor * small.polygonal_thickness);
    EXPECT_EQ(big.ropelength, small.ropelength);
    EXPECT_EQ(big.min_clearance, factor * small.min_clearance);
    EXPECT_EQ(big.average_crossing_number, small.average_crossing_number);
    EXPECT_EQ(big.linking_matrix, small.linking_matrix);
  }
}

TEST(Curve_measures, of_an_empty_network_are_defined)
{
  const auto measures = vfc::measure(Curve());
  EXPECT_EQ(measures.length, 0);
  EXPECT_TRUE(measures.linking_matrix.empty());
}

#ifndef NDEBUG
TEST(Curve_measures, demand_a_network_without_garbage)
{
  Curve curve = vfc::make_regular_polygon(12);
  vfc::Isotopy_guard_3<> guard(curve);
  ASSERT_TRUE(guard.remove_node(3));
  EXPECT_THROW((void)vfc::length(curve), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::component_lengths(curve), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::total_curvatures(curve), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::min_bend_radius(curve), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::tightest_bend(curve), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::min_clearance(curve), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::polygonal_thickness(curve), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::min_strand_distance(curve, 1), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::crowded_fraction(curve, 1), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::average_crossing_number(curve), CGAL::Precondition_exception);
  EXPECT_THROW((void)vfc::linking_matrix(curve), CGAL::Precondition_exception);
  std::vector<std::vector<Point>> polylines;
  EXPECT_THROW(vfc::curve_network_to_polylines(curve, std::back_inserter(polylines)),
               CGAL::Precondition_exception);
}
#endif

} // namespace test_curve_measures
