// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Where in the input the nodes of an edited network come from.

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace test_curve_origins {

using namespace CGAL::Volume_filling_curves;
using Network = Curve_network_3<>;
using Guard = Isotopy_guard_3<>;
using Point_3 = Network::Point_3;
using Polyline = std::vector<Point_3>;

void expect_origin(const Curve_origin& origin, std::size_t source, std::size_t target, double t)
{
  EXPECT_EQ(origin.source, source);
  EXPECT_EQ(origin.target, target);
  EXPECT_NEAR(origin.parameter, t, 1e-12);
}

Point_3 middle(const Network& network, std::size_t e)
{
  return CGAL::midpoint(network.point(network.source(e)), network.point(network.target(e)));
}

// Inserts nodes and removes others at random, and renumbers from time to time.
void edit(Network& network, std::size_t number_of_changes, std::mt19937& random)
{
  Guard guard(network);
  for(std::size_t k = 0; k < number_of_changes; ++k) {
    const std::size_t e = random() % network.number_of_edges();
    const std::size_t v = random() % network.number_of_nodes();
    if(random() % 2 == 0)
      guard.insert_node(e, middle(network, e));
    else
      guard.remove_node(v);
    guard.collect_garbage();
  }
}

// The number along the input of the origin of each node, for a single curve.
std::vector<double> ranks(const Network& network)
{
  std::vector<double> result;
  for(const Curve_origin& origin : curve_origins(network)) {
    EXPECT_LE(0, origin.parameter);
    EXPECT_LE(origin.parameter, 1);
    result.push_back(static_cast<double>(origin.source) + origin.parameter);
  }
  return result;
}

void expect_survivors_to_stay(const Network& network, const std::vector<double>& rank)
{
  for(const std::size_t v : network.nodes()) {
    if(network.origin(v) == Network::null_node()) continue;
    EXPECT_EQ(rank[v], static_cast<double>(network.origin(v)));
  }
}

TEST(Origins, of_the_input_are_the_nodes_themselves)
{
  const Network arc(Polyline{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  const auto origins = curve_origins(arc);
  expect_origin(origins[0], 0, 1, 0);
  expect_origin(origins[1], 1, 2, 0);
  expect_origin(origins[2], 1, 2, 1);
  const auto of_polygon = curve_origins(make_regular_polygon(3));
  expect_origin(of_polygon[2], 2, 0, 0);
  EXPECT_TRUE(curve_origins(Network()).empty());
}

TEST(Origins, are_interpolated_by_length)
{
  Network arc(Polyline{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 3, 0}});
  Guard guard(arc);
  ASSERT_TRUE(guard.insert_node(1, {1, 0.25, 0}));
  guard.collect_garbage();
  expect_origin(curve_origins(arc)[2], 1, 2, 0.25);
  ASSERT_TRUE(guard.remove_node(3));
  guard.collect_garbage();
  expect_origin(curve_origins(arc)[2], 1, 2,
                2 * 0.25 / 3); // each edge of the input counts the same
}

TEST(Origins, run_once_around_a_curve_of_which_one_node_is_left)
{
  Network square(Polyline{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}});
  Guard guard(square);
  for(const std::size_t e : {0u, 1u, 2u, 3u}) ASSERT_TRUE(guard.insert_node(e, middle(square, e)));
  for(const std::size_t v : {0u, 1u, 3u}) ASSERT_TRUE(guard.remove_node(v));
  guard.collect_garbage();
  std::size_t number_of_survivors = 0;
  const auto origins = curve_origins(square);
  for(const std::size_t v : square.nodes()) {
    if(square.origin(v) == Network::null_node()) continue;
    ++number_of_survivors;
    expect_origin(origins[v], 2, 3, 0);
  }
  EXPECT_EQ(number_of_survivors, 1u);
}

TEST(Origins, start_with_the_input_if_no_node_is_left)
{
  Network square(Polyline{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}});
  Guard guard(square);
  for(const std::size_t e : {0u, 1u, 2u, 3u}) ASSERT_TRUE(guard.insert_node(e, middle(square, e)));
  for(const std::size_t v : {0u, 1u, 2u, 3u}) ASSERT_TRUE(guard.remove_node(v));
  guard.collect_garbage();
  const auto origins = curve_origins(square);
  for(const std::size_t v : {0u, 1u, 2u, 3u}) expect_origin(origins[v], v, (v + 1) % 4, 0);
}

TEST(Origins, of_an_arc_never_run_backwards_and_keep_what_is_left)
{
  std::mt19937 random(1);
  Polyline points;
  for(int i = 0; i < 30; ++i) points.emplace_back(i, i % 3, i % 5);
  for(int repetition = 0; repetition < 20; ++repetition) {
    Network arc(points);
    edit(arc, 100, random);
    const std::vector<double> rank = ranks(arc);
    for(std::size_t v = 0; v + 1 < rank.size(); ++v) EXPECT_LE(rank[v], rank[v + 1]);
    expect_survivors_to_stay(arc, rank);
  }
}

TEST(Origins, of_a_closed_curve_run_around_it_once)
{
  std::mt19937 random(2);
  for(int repetition = 0; repetition < 20; ++repetition) {
    Network knot = make_torus_knot(2, 3, 50);
    edit(knot, 200, random);
    const std::vector<double> rank = ranks(knot);
    std::size_t number_of_starts = 0;
    for(std::size_t v = 0; v < rank.size(); ++v)
      if(rank[(v + 1) % rank.size()] < rank[v]) ++number_of_starts;
    EXPECT_EQ(number_of_starts, 1u);
    expect_survivors_to_stay(knot, rank);
  }
}

// Two junctions that three arcs join, and a loop at one of them: the arcs have the same ends, so
// that only the labels of their edges identify them when none of their nodes is left.
TEST(Origins, in_a_network_stay_on_their_chains)
{
  std::mt19937 random(3);
  const Point_3 a(0, 0, 0), b(10, 0, 0);
  const std::vector<Polyline> arcs = {{a, {2, 2, 0}, {5, 3, 0}, b},
                                      {a, {2, -2, 0}, {5, -3, 0}, b},
                                      {b, {5, 0, 3}, {2, 0, 2}, a},
                                      {b, {12, 1, 0}, {12, 0, 1}, {12, -1, 0}, b}};
  for(int repetition = 0; repetition < 30; ++repetition) {
    Network network(arcs, parameters::junctions(Junctions::ALLOWED));
    edit(network, 60, random);
    const auto origins = curve_origins(network);
    for(const std::size_t v : network.nodes()) {
      const Point_3& p = network.point(v);
      const auto& [source, target, parameter] = origins[v];
      if(network.degree(v) > 2) {
        EXPECT_TRUE(source == network.origin(v) || target == network.origin(v));
        continue;
      }
      if(p.y() == 0 && p.z() == 0) continue; // an arc became straight, whichever it is
      // Points in the order of the input: 0 a, 1, 2, 3 b | 4, 5 | 6, 7 | 8, 9, 10
      using Range = std::array<std::size_t, 2>;
      const Range range = p.x() > 10  ? Range{8, 10}
                          : p.z() > 0 ? Range{6, 7}
                          : p.y() > 0 ? Range{1, 2}
                                      : Range{4, 5};
      const auto is_inside = [&](std::size_t w) { return range[0] <= w && w <= range[1]; };
      EXPECT_TRUE(is_inside(source) || is_inside(target));
    }
  }
}

} // namespace test_curve_origins
