// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// How close strands come to one another, and how tightly a curve bends, with the places.
namespace test_crowding {

namespace vfc = CGAL::Volume_filling_curves;
namespace internal = CGAL::Volume_filling_curves::internal;
using internal::Vector;
using Curve = vfc::Curve_network_3<>;
using Point = Curve::Point_3;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto no_edge = static_cast<std::size_t>(-1);

Curve path(const std::vector<Point>& points)
{
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t i = 1; i < points.size(); ++i) edges.push_back({i - 1, i});
  return Curve(points, edges);
}

// Two parallel lines, the second of n edges of length 1 at the given height.
Curve two_lines(std::size_t n, double height)
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(const double z : {0., height})
    for(std::size_t i = 0; i <= n; ++i) {
      if(i > 0) edges.push_back({points.size() - 1, points.size()});
      points.emplace_back(static_cast<double>(i), 0, z);
    }
  return Curve(points, edges);
}

// A pseudo-random tangle of even edges.
Curve tangle()
{
  return internal::closed_network(
      internal::braid_closure(vfc::parse_braid_word("1 -2 3 1 -2 3 -1 2 -3 1 1"), 400, 0));
}

Vector position(const Curve& curve, std::size_t v)
{
  return internal::to_vector(curve.point(v));
}

double edge_distance(const Curve& curve, std::size_t e, std::size_t f)
{
  return std::sqrt(internal::squared_segment_distance(
      position(curve, curve.source(e)), position(curve, curve.target(e)),
      position(curve, curve.source(f)), position(curve, curve.target(f))));
}

double edge_length(const Curve& curve, std::size_t e)
{
  return (position(curve, curve.target(e)) - position(curve, curve.source(e))).norm();
}

Point middle(const Curve& curve, std::size_t e)
{
  return CGAL::midpoint(curve.point(curve.source(e)), curve.point(curve.target(e)));
}

// Places along closed components, in lengths of the curve.
struct Lengths_along
{
  std::vector<double> at, total; // at each node, and of each component

  explicit Lengths_along(const Curve& curve)
      : at(curve.number_of_nodes()), total(curve.number_of_components())
  {
    std::vector<std::size_t> edge_from(curve.number_of_nodes());
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e) edge_from[curve.source(e)] = e;
    for(std::size_t c = 0; c < total.size(); ++c) {
      std::size_t v = curve.first_node(c);
      do {
        at[v] = total[c];
        total[c] += edge_length(curve, edge_from[v]);
        v = curve.target(edge_from[v]);
      } while(v != curve.first_node(c));
    }
  }

  // How much of a closed curve lies between two edges of its component.
  double between(const Curve& curve, std::size_t e, std::size_t f) const
  {
    if(at[curve.source(e)] > at[curve.source(f)]) std::swap(e, f);
    const double first = at[curve.source(e)], second = at[curve.source(f)];
    const double all = total[curve.component(curve.source(e))];
    return (std::min)(second - first - edge_length(curve, e),
                      all - (second + edge_length(curve, f) - first));
  }
};

// The same by definition, in quadratic time.
template <typename Thickness>
std::array<double, 2> distance_and_crowding(const Curve& curve, const Thickness& thickness)
{
  const Lengths_along lengths(curve);
  double least = infinity, crowded = 0;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    bool is_crowded = false;
    for(std::size_t f = 0; f < curve.number_of_edges(); ++f) {
      if(e == f || internal::share_a_node(curve, e, f)) continue;
      const double r = (thickness(middle(curve, e)) + thickness(middle(curve, f))) / 2;
      const bool is_one_component =
          curve.component(curve.source(e)) == curve.component(curve.source(f));
      if(is_one_component && lengths.between(curve, e, f) < CGAL_PI * r) continue;
      least = (std::min)(least, edge_distance(curve, e, f));
      is_crowded = is_crowded || edge_distance(curve, e, f) < r;
    }
    if(is_crowded) crowded += edge_length(curve, e);
  }
  return {least, crowded / vfc::length(curve)};
}

TEST(Tightest_bend, is_the_corner_with_the_least_radius)
{
  const Curve curve = path({Point(0, 0, 0), Point(4, 0, 0), Point(8, 1, 0), Point(8, 5, 0),
                            Point(7.5, 9, 0), Point(0, 9, 0)});
  const auto bend = vfc::tightest_bend(curve);
  EXPECT_EQ(bend.radius, vfc::min_bend_radius(curve));
  ASSERT_LT(bend.node, curve.number_of_nodes());
  EXPECT_EQ(curve.point(bend.node), Point(7.5, 9, 0));
}

TEST(Tightest_bend, is_nowhere_on_a_straight_curve)
{
  const auto bend = vfc::tightest_bend(path({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)}));
  EXPECT_EQ(bend.radius, infinity);
  EXPECT_EQ(bend.node, no_edge);
  EXPECT_EQ(vfc::tightest_bend(Curve()).node, no_edge);
}

TEST(Strand_distance, has_its_places)
{
  const Curve crossing({Point(-1, 0, 0), Point(1, 0, 0), Point(0, -1, 3), Point(0, 1, 3)},
                       {{0, 1}, {2, 3}});
  const auto strands = vfc::min_strand_distance(crossing, 10.);
  EXPECT_EQ(strands.distance, 3);
  EXPECT_EQ(strands.points[0], Point(0, 0, 0));
  EXPECT_EQ(strands.points[1], Point(0, 0, 3));
}

TEST(Strand_distance, is_infinite_for_a_single_strand)
{
  const auto strands = vfc::min_strand_distance(path({Point(0, 0, 0), Point(1, 0, 0)}), 1.);
  EXPECT_EQ(strands.distance, infinity);
  EXPECT_EQ(strands.edges, (std::array<std::size_t, 2>{no_edge, no_edge}));
}

TEST(Strand_distance, is_that_of_its_definition)
{
  const Curve curve = tangle();
  const double edge = vfc::length(curve) / static_cast<double>(curve.number_of_edges());
  for(const double factor : {0.5, 2., 5.}) {
    const double r = factor * edge;
    const auto strands = vfc::min_strand_distance(curve, r);
    EXPECT_DOUBLE_EQ(strands.distance,
                     distance_and_crowding(curve, [r](const Point&) { return r; })[0]);
    EXPECT_EQ(strands.distance, vfc::min_clearance(curve, r));
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(strands.points[0], strands.points[1])),
                strands.distance, 1e-9 * strands.distance);
  }
}

TEST(Crowded_fraction, is_the_share_of_edges_with_a_near_strand)
{
  EXPECT_EQ(vfc::crowded_fraction(two_lines(5, 1), 0.99), 0);
  EXPECT_EQ(vfc::crowded_fraction(two_lines(5, 1), 1.01), 1);
  EXPECT_EQ(vfc::crowded_fraction(two_lines(5, 1), 1.), 0); // not nearer
  EXPECT_EQ(vfc::crowded_fraction(Curve(), 1.), 0);
  // r is 2 near the start of the lines and 0.5 beyond 2.2
  const auto thickness = [](const Point& p) { return p.x() < 2.2 ? 2 : 0.5; };
  EXPECT_NEAR(vfc::crowded_fraction(two_lines(5, 1), thickness), 0.6, 1e-12);
}

TEST(Crowded_fraction, is_that_of_its_definition_for_any_thickness_and_number_of_threads)
{
  const Curve curve = tangle();
  const double edge = vfc::length(curve) / static_cast<double>(curve.number_of_edges());
  const auto bbox_side = curve.point(0).x();
  for(const double factor : {0.5, 1., 2., 4.}) {
    const auto thickness = [&](const Point& p) {
      return factor * edge * (p.x() > bbox_side ? 1 : 0.6);
    };
    const auto [distance, crowded] = distance_and_crowding(curve, thickness);
    EXPECT_DOUBLE_EQ(vfc::min_strand_distance(curve, thickness).distance, distance);
    EXPECT_NEAR(vfc::crowded_fraction(curve, thickness), crowded, 1e-12);
    EXPECT_EQ(vfc::crowded_fraction<CGAL::Parallel_if_available_tag>(curve, thickness),
              vfc::crowded_fraction(curve, thickness));
  }
}

} // namespace test_crowding
