// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// No change bends a curve tighter, or brings its strands nearer, than a guard is asked to keep.
namespace test_bend_limits {

namespace vfc = CGAL::Volume_filling_curves;
using Curve = vfc::Curve_network_3<>;
using Point = Curve::Point_3;
using Guard = vfc::Isotopy_guard_3<>;
using Limits = vfc::Bend_limits<Point>;
using Field = vfc::internal::Vector_field;
using vfc::internal::Random_source;
using vfc::internal::to_vector;
using vfc::internal::Vector;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Coaxial circles of radius 1 at the given heights.
Curve circles(const std::vector<double>& heights, std::size_t n)
{
  std::vector<std::vector<Point>> polylines;
  for(const double z : heights) {
    polylines.emplace_back();
    for(std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
      polylines.back().emplace_back(std::cos(angle), std::sin(angle), z);
    }
    polylines.back().push_back(polylines.back().front());
  }
  return Curve(polylines);
}

Curve path(const std::vector<Point>& points)
{
  return Curve(points);
}

// The least bend radius at any node, by its definition.
double min_radius(const Curve& curve)
{
  double least = infinity;
  for(const std::size_t v : curve.nodes()) {
    if(curve.degree(v) != 2) continue;
    const Vector a = to_vector(curve.point(v)) - to_vector(curve.point(curve.neighbor(v, 0)));
    const Vector b = to_vector(curve.point(curve.neighbor(v, 1))) - to_vector(curve.point(v));
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    least = (std::min)(least, (std::min)(a.norm(), b.norm()) / (2 * std::tan(angle / 2)));
  }
  return least;
}

// The nodes of each closed component, in the order of the curve.
std::vector<std::vector<std::size_t>> loops(const Curve& curve)
{
  std::vector<std::vector<std::size_t>> loops;
  std::vector<bool> is_seen(curve.number_of_nodes() + curve.number_of_removed_nodes(), false);
  for(const std::size_t start : curve.nodes()) {
    if(is_seen[start]) continue;
    loops.emplace_back();
    for(std::size_t v = start; !is_seen[v];) {
      is_seen[v] = true;
      loops.back().push_back(v);
      const std::size_t w = curve.neighbor(v, 0);
      v = is_seen[w] ? curve.neighbor(v, 1) : w;
    }
  }
  return loops;
}

// The least distance of edges of different strands, by its definition.
double min_distance(const Curve& curve, const Limits& limits)
{
  using Segment = CGAL::Segment_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  struct Edge
  {
    Segment segment;
    std::size_t loop;
    double from, to;
  };
  std::vector<Edge> edges;
  std::vector<double> totals;
  for(const auto& loop : loops(curve)) {
    double length = 0;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Segment s(curve.point(loop[i]), curve.point(loop[(i + 1) % loop.size()]));
      const double next = length + std::sqrt(s.squared_length());
      edges.push_back({s, totals.size(), length, next});
      length = next;
    }
    totals.push_back(length);
  }
  const double between = CGAL_PI * (std::max)(limits.bend_radius, limits.strand_distance / 2);
  double least = infinity;
  for(std::size_t i = 0; i < edges.size(); ++i)
    for(std::size_t j = 0; j < i; ++j) {
      const Edge &f = edges[i], &e = edges[j];
      const double gap = (std::min)(f.from - e.to, totals[e.loop] - f.to + e.from);
      if(e.loop == f.loop && gap < between) continue;
      least = (std::min)(least, std::sqrt(CGAL::squared_distance(e.segment, f.segment)));
    }
  return least;
}

Field positions(const Curve& curve)
{
  return vfc::internal::coordinates(curve);
}

Vector random_vector(Random_source& random, double size)
{
  const auto coordinate = [&] { return size * (2 * random.real() - 1); };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

Field shaken(const Curve& curve, Random_source& random, double size)
{
  Field x = positions(curve);
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    vfc::internal::set_row(x, v, vfc::internal::row(x, v) + random_vector(random, size));
  return x;
}

constexpr double R = 0.9, d = 0.45;
constexpr double rounding = 1e-12;

Limits limits()
{
  Limits result;
  result.bend_radius = R;
  result.strand_distance = d;
  return result;
}

TEST(Bend_limits, of_less_than_zero_are_none)
{
  Curve strands({Point(0, 0, 0), Point(1, 1, 0), Point(0, 0.4, 0), Point(0.6, 1, 0)},
                {{0, 1}, {2, 3}});
  Guard guard(strands);
  guard.set_bend_limits({1, -1, {}});
  Field targets = vfc::internal::coordinates(strands);
  targets(2, 1) = 0.3; // nearer, but their boxes overlap before
  targets(3, 1) = 0.9;
  EXPECT_EQ(guard.move_nodes(targets), 1);
}

TEST(Bend_limits, refuse_a_move_that_bends_tighter)
{
  for(const bool are_set : {false, true}) {
    Curve curve = circles({0}, 40);
    Guard guard(curve);
    if(are_set) guard.set_bend_limits(limits());
    EXPECT_EQ(guard.move_node(0, Point(0.9, 0, 0)), !are_set);
    EXPECT_TRUE(guard.move_node(7, CGAL::midpoint(curve.point(7), curve.point(7))));
  }
}

TEST(Bend_limits, refuse_a_move_that_brings_strands_nearer)
{
  for(const bool are_set : {false, true}) {
    Curve curve = circles({0, 0.5}, 12);
    Guard guard(curve);
    Limits distance_only;
    if(are_set) distance_only.strand_distance = d;
    guard.set_bend_limits(distance_only);
    const Point p = curve.point(3);
    EXPECT_TRUE(guard.move_node(3, Point(p.x(), p.y(), 0.04)));
    EXPECT_EQ(guard.move_node(3, Point(p.x(), p.y(), 0.06)), !are_set);
  }
}

TEST(Bend_limits, let_a_curve_that_violates_them_get_better_but_not_worse)
{
  Curve curve = path({Point(-1, 0, 0), Point(0, 0.9, 0), Point(1, 0, 0)}); // bends at 0.74
  Guard guard(curve);
  guard.set_bend_limits(limits());
  EXPECT_FALSE(guard.move_node(1, Point(0, 0.95, 0)));
  EXPECT_TRUE(guard.move_node(1, Point(0, 0.85, 0)));
  EXPECT_LT(min_radius(curve), R);
  EXPECT_FALSE(guard.move_node(1, Point(0, 0.9, 0)));
}

TEST(Bend_limits, refuse_a_split_and_a_collapse_that_bend_tighter)
{
  for(const bool are_set : {false, true}) {
    Curve curve = circles({0}, 40);
    Guard guard(curve);
    if(are_set) guard.set_bend_limits(limits());
    // an edge of half the length bends as the corner before with half of the radius
    EXPECT_EQ(guard.insert_node(0, CGAL::midpoint(curve.point(0), curve.point(1))), !are_set);
  }
  for(const bool are_set : {false, true}) {
    // without the node in the middle both corners are sharper
    Curve curve = path(
        {Point(-3, -2, 0), Point(-1, 0, 0), Point(0, 0.3, 0), Point(1, 0, 0), Point(3, -2, 0)});
    Guard guard(curve);
    Limits bend;
    if(are_set) bend.bend_radius = 3;
    guard.set_bend_limits(bend);
    EXPECT_EQ(guard.remove_node(2), true); // gets the corners rounder
  }
  for(const bool are_set : {false, true}) {
    Curve curve = path(
        {Point(-4, 1, 0), Point(-1, 0, 0), Point(0, -0.1, 0), Point(1, 0, 0), Point(1.2, 2, 0)});
    Guard guard(curve);
    Limits bend;
    const double before = min_radius(curve);
    if(are_set) bend.bend_radius = 3;
    guard.set_bend_limits(bend);
    const bool is_removed = guard.remove_node(2);
    if(are_set) {
      EXPECT_GE(min_radius(curve), (std::min)(3., before) * (1 - rounding));
    }
    if(!are_set) {
      EXPECT_TRUE(is_removed);
    }
  }
}

TEST(Bend_limits, refuse_a_collapse_and_a_split_that_bring_strands_nearer)
{
  // a line, and an arch over it whose top can be cut off, or lowered by a new node
  const std::vector<Point> points = {Point(-3, 0, 0), Point(3, 0, 0), Point(-3, 0, 1),
                                     Point(-1, 0, 1), Point(0, 0, 2), Point(1, 0, 1),
                                     Point(3, 0, 1)};
  for(const bool are_set : {false, true}) {
    Curve curve(points, {{0, 1}, {2, 3}, {3, 4}, {4, 5}, {5, 6}});
    Guard guard(curve);
    Limits distance;
    if(are_set) distance.strand_distance = 1.2;
    guard.set_bend_limits(distance);
    std::size_t straight = 0;
    while(curve.point(curve.source(straight)) != Point(-3, 0, 1)) ++straight;
    EXPECT_EQ(guard.insert_node(straight, Point(-2, 0, 0.9)), !are_set);
  }
  for(const bool are_set : {false, true}) {
    Curve curve({Point(-3, 0, 0), Point(3, 0, 0), Point(-3, 0, 2), Point(-1, 0, 1.5),
                 Point(0, 0, 2.5), Point(1, 0, 1), Point(3, 0, 2)},
                {{0, 1}, {2, 3}, {3, 4}, {4, 5}, {5, 6}});
    Guard guard(curve);
    Limits distance;
    // a chord over the valley at (1, 0, 1) raises the curve; over the ridge it does not lower it
    if(are_set) distance.strand_distance = 2;
    guard.set_bend_limits(distance);
    std::size_t ridge = 0;
    while(curve.point(ridge) != Point(0, 0, 2.5)) ++ridge;
    EXPECT_TRUE(guard.remove_node(ridge)); // the least distance to the line was 1 before, too
  }
  for(const bool are_set : {false, true}) {
    // the chord passes the line that the two edges went around
    Curve curve({Point(0, -3, 1), Point(0, 3, 1), Point(-2, 0, 0), Point(0, 0, -1), Point(2, 0, 0)},
                {{0, 1}, {2, 3}, {3, 4}});
    Guard guard(curve);
    Limits distance;
    if(are_set) distance.strand_distance = 1.5;
    guard.set_bend_limits(distance);
    std::size_t middle = 0;
    while(curve.point(middle) != Point(0, 0, -1)) ++middle;
    EXPECT_EQ(guard.remove_node(middle), !are_set);
  }
}

// Twice: nodes that go the same part of their ways, or each its own.
TEST(Bend_limits, hold_in_motions_of_all_nodes)
{
  for(const bool is_each_its_own : {false, true}) {
    Curve curve = circles({0, 0.5}, 40);
    Guard guard(curve);
    guard.set_bend_limits(limits());
    Random_source random(7);
    std::size_t moved = 0;
    for(int k = 0; k < 60; ++k) {
      const Field targets = shaken(curve, random, k % 2 == 0 ? 0.002 : 0.05);
      const Field before = positions(curve);
      if(is_each_its_own)
        guard.advance_nodes(targets);
      else
        guard.move_nodes(targets, 1e-4);
      if(positions(curve) != before) ++moved;
      ASSERT_GE(min_radius(curve), R * (1 - rounding)) << k;
      ASSERT_GE(min_distance(curve, limits()), d * (1 - rounding)) << k;
    }
    EXPECT_GT(moved, 20u);
  }
}

TEST(Bend_limits, hold_if_nodes_are_moved_inserted_and_removed_at_random)
{
  Curve curve = circles({0, 0.5}, 24);
  Guard guard(curve);
  Limits some = limits();
  some.bend_radius = 0.4; // edges can be split
  guard.set_bend_limits(some);
  Random_source random(3);
  std::array<std::size_t, 3> made{};
  for(int k = 0; k < 600; ++k) {
    const std::size_t v = random.index(curve.number_of_nodes());
    const std::size_t e = random.index(curve.number_of_edges());
    const Vector way = random_vector(random, 0.1);
    const auto moved = [&](const Point& p) {
      return Point(p.x() + way.x(), p.y() + way.y(), p.z() + way.z());
    };
    const int kind = k % 3;
    bool is_made = false;
    if(kind == 0) is_made = guard.move_node(v, moved(curve.point(v)));
    if(kind == 1)
      is_made = guard.insert_node(
          e, moved(CGAL::midpoint(curve.point(curve.source(e)), curve.point(curve.target(e)))));
    if(kind == 2) is_made = guard.remove_node(v);
    made[static_cast<std::size_t>(kind)] += is_made;
    guard.collect_garbage();
    ASSERT_GE(min_radius(curve), some.bend_radius * (1 - rounding)) << k;
    ASSERT_GE(min_distance(curve, some), d * (1 - rounding)) << k;
  }
  for(const std::size_t number : made) EXPECT_GT(number, 5u);
}

TEST(Bend_limits, depend_on_the_place_by_a_scale)
{
  Curve curve = circles({0, 0.5}, 12);
  Guard guard(curve);
  Limits varying;
  varying.strand_distance = d;
  varying.scale = [](const Point& p) { return p.x() > 0 ? 1. : 0.5; };
  guard.set_bend_limits(varying);
  EXPECT_FALSE(guard.move_node(0, Point(1, 0, 0.1)));
  EXPECT_TRUE(guard.move_node(6, Point(-1, 0, 0.1)));
}

TEST(Bend_limits, give_the_same_bits_for_any_number_of_threads)
{
  const auto shaken_circles = [](auto tag) {
    Curve curve = circles({0, 0.5}, 40);
    Guard guard(curve);
    guard.set_bend_limits(limits());
    Random_source random(5);
    for(int k = 0; k < 20; ++k) guard.advance_nodes<decltype(tag)>(shaken(curve, random, 0.02));
    return positions(curve);
  };
  EXPECT_EQ(shaken_circles(CGAL::Sequential_tag()),
            shaken_circles(CGAL::Parallel_if_available_tag()));
}

} // namespace test_bend_limits
