// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"
#include "support/refusal_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <list>
#include <stdexcept>
#include <string>

// Numbering, inserting, removing and collecting garbage, compared with lists of nodes.
namespace test_curve_network_3 {

using namespace guard_test;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
using Point = Network::Point_3;
using Edges = std::vector<std::array<std::size_t, 2>>;

// A node as a user sees it: where it is, and which one of the input it was.
struct Record
{
  Point point;
  std::size_t origin;
  bool is_pinned;

  bool operator==(const Record& other) const
  {
    return point == other.point && origin == other.origin && is_pinned == other.is_pinned;
  }
};

struct Component
{
  std::list<Record> nodes;
  bool is_closed;
  bool has_lost_first_node = false;
};

// Components as lists; positions are random, so that hardly any change is refused.
struct List_model
{
  std::vector<Component> components;

  static List_model of(const Network& network)
  {
    List_model model;
    for(std::size_t c = 0; c < network.number_of_components(); ++c) {
      model.components.push_back({{}, network.is_closed(c), false});
      for(std::size_t v = network.first_node(c); v < network.first_node(c + 1); ++v)
        model.components.back().nodes.push_back(
            {network.point(v), network.origin(v), network.is_pinned(v)});
    }
    return model;
  }

  bool operator==(const List_model& other) const
  {
    return std::equal(components.begin(), components.end(), other.components.begin(),
                      other.components.end(), [](const Component& a, const Component& b) {
                        return a.nodes == b.nodes && a.is_closed == b.is_closed;
                      });
  }

  // the component and place of the node at a position
  std::pair<Component*, std::list<Record>::iterator> find(const Point& p)
  {
    for(Component& component : components)
      for(auto it = component.nodes.begin(); it != component.nodes.end(); ++it)
        if(it->point == p) return {&component, it};
    return {nullptr, {}};
  }

  // Lets closed components that lost their first node start where those of the network do.
  void adopt_first_nodes(const Network& network)
  {
    for(std::size_t c = 0; c < components.size(); ++c) {
      if(!components[c].has_lost_first_node) continue;
      const auto [component, it] = find(network.point(network.first_node(c)));
      component->nodes.splice(component->nodes.end(), component->nodes, component->nodes.begin(),
                              it);
      component->has_lost_first_node = false;
    }
  }

  void insert(const Point& source, const Point& p)
  {
    const auto [component, it] = find(source);
    component->nodes.insert(std::next(it), {p, Network::null_node(), false});
  }

  void remove(const Point& p)
  {
    const auto [component, it] = find(p);
    if(it == component->nodes.begin()) component->has_lost_first_node = true;
    component->nodes.erase(it);
  }

  void move(const Point& from, const Point& to) { find(from).second->point = to; }
};

// Checks that nodes and edges run along the components.
void expect_numbered_along_curves(const Network& network)
{
  ASSERT_FALSE(network.has_garbage());
  for(std::size_t c = 0; c < network.number_of_components(); ++c) {
    const std::size_t first = network.first_node(c), last = network.first_node(c + 1);
    for(std::size_t v = first; v < last; ++v) {
      EXPECT_EQ(network.component(v), c);
      const std::size_t next = v + 1 < last ? v + 1 : first;
      std::size_t count = 0;
      for(std::size_t k = 0; k < network.degree(v); ++k) {
        const std::size_t e = network.incident_edge(v, k);
        EXPECT_EQ(network.source(e) == v ? network.target(e) : network.source(e),
                  network.neighbor(v, k));
        count += network.source(e) == v && network.target(e) == next;
      }
      EXPECT_EQ(count, v + 1 < last || network.is_closed(c) ? 1u : 0u);
    }
  }
}

Point random_position(Random& random)
{
  std::uniform_real_distribution<double> coordinate(-100, 100);
  const double x = coordinate(random), y = coordinate(random);
  return {x, y, coordinate(random)};
}

Network random_rings_and_paths(Random& random)
{
  Curve curve;
  std::vector<Point> points;
  const std::size_t n = 1 + below(4, random);
  for(std::size_t c = 0; c < n; ++c)
    add_strand(curve, 4 + below(5, random), below(2, random) == 0, brute_force::no_node);
  for(std::size_t v = 0; v < curve.points.size(); ++v) points.push_back(random_position(random));
  Network network(points, curve.edges);
  for(std::size_t v = 0; v < network.number_of_nodes(); ++v)
    network.set_pinned(v, below(8, random) == 0);
  return network;
}

void expect_counted(const Network& network)
{
  const auto nodes = network.nodes();
  const auto edges = network.edges();
  ASSERT_EQ(network.number_of_nodes(),
            static_cast<std::size_t>(std::distance(nodes.begin(), nodes.end())));
  ASSERT_EQ(network.number_of_edges(),
            static_cast<std::size_t>(std::distance(edges.begin(), edges.end())));
}

TEST(Curve_network, counts_no_nodes_and_edges_that_were_removed)
{
  Network network({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  Guard guard(network);
  ASSERT_TRUE(guard.remove_node(1));
  EXPECT_EQ(network.number_of_nodes(), 3u);
  EXPECT_EQ(network.number_of_edges(), 3u);
  EXPECT_EQ(network.number_of_removed_nodes(), 1u);
  EXPECT_EQ(network.number_of_removed_edges(), 1u);
  ASSERT_TRUE(guard.insert_node(2, {1.5, 0.75, 0}));
  EXPECT_EQ(network.number_of_nodes(), 4u);
  EXPECT_EQ(network.target(2), 4u); // has an index of its own as long as there is garbage
  guard.collect_garbage();
  EXPECT_EQ(network.number_of_nodes(), 4u);
  EXPECT_EQ(network.number_of_edges(), 4u);
  EXPECT_EQ(network.number_of_removed_nodes() + network.number_of_removed_edges(), 0u);
}

TEST(Curve_network, follows_lists_of_nodes_through_random_changes)
{
  Random random(1);
  int number_of_changes = 0;
  for(int repeat = 0; repeat < 300; ++repeat) {
    Network network = random_rings_and_paths(random);
    Guard guard(network);
    List_model model = List_model::of(network);
    expect_numbered_along_curves(network);
    for(int k = 0; k < 200; ++k) {
      const std::size_t v = below(number_of_node_indices(network), random);
      const std::size_t e = below(number_of_edge_indices(network), random);
      const std::size_t dice = below(10, random);
      const Point p = random_position(random);
      if(dice < 4 && !network.is_removed_edge(e)) {
        const Point source = network.point(network.source(e));
        if(!guard.insert_node(e, p)) continue;
        model.insert(source, p);
      } else if(dice < 8 && !network.is_removed_node(v)) {
        const Point old = network.point(v);
        if(!guard.remove_node(v)) continue;
        EXPECT_TRUE(network.is_removed_node(v));
        model.remove(old);
      } else if(dice < 9 && !network.is_removed_node(v)) {
        const Point old = network.point(v);
        if(!guard.move_node(v, p)) continue;
        model.move(old, p);
      } else if(below(3, random) == 0) {
        const Network before = network;
        const auto former = guard.collect_garbage();
        ASSERT_EQ(former.size(), network.number_of_nodes());
        for(std::size_t w = 0; w < former.size(); ++w) {
          EXPECT_EQ(network.point(w), before.point(former[w]));
          EXPECT_EQ(network.origin(w), before.origin(former[w]));
        }
        model.adopt_first_nodes(network);
        ASSERT_TRUE(List_model::of(network) == model);
        expect_numbered_along_curves(network);
      }
      expect_counted(network);
      ++number_of_changes;
    }
  }
  EXPECT_GT(number_of_changes, 10000);
}

TEST(Curve_network, maps_nodes_to_the_input)
{
  const std::vector<Point> points = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                     {5, 0, 0}, {5, 1, 0}, {5, 2, 0}};
  const Network network(points, {{6, 5}, {5, 4}, {2, 3}, {3, 1}, {1, 2}});
  ASSERT_EQ(network.number_of_nodes(), 6u);
  const std::vector<std::size_t> expected = {6, 5, 4, 1, 2, 3};
  for(std::size_t v = 0; v < 6; ++v) {
    EXPECT_EQ(network.origin(v), expected[v]);
    EXPECT_EQ(network.point(v), points[expected[v]]);
  }
  EXPECT_FALSE(network.is_closed(0));
  EXPECT_TRUE(network.is_closed(1));
  expect_numbered_along_curves(network);
}

TEST(Curve_network, orients_components_whose_edges_disagree)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  expect_numbered_along_curves(Network(points, {{2, 1}, {0, 1}, {2, 3}, {0, 3}}));
  expect_numbered_along_curves(Network(points, {{1, 0}, {1, 2}, {3, 2}}));
}

TEST(Curve_network, names_the_edge_that_is_wrong)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}};
  const auto message = [&](const Edges& edges) {
    return refusal_of([&] { Network(points, edges); });
  };
  EXPECT_EQ(message({{0, 2}}), "edge (0, 2) has no such node");
  EXPECT_EQ(message({{1, 1}}), "edge (1, 1) joins a node with itself");
  EXPECT_EQ(message({{0, 1}, {1, 0}}), "edge (1, 0) occurs twice");
  EXPECT_EQ(message({{0, 1}}), "");
}

TEST(Curve_network, refuses_coordinates_that_are_not_finite_and_names_the_point)
{
  for(const double x :
      {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    try {
      const Network network({{0, 0, 0}, {1, 0, 0}, {0, x, 0}}, {{0, 1}, {1, 2}});
      ADD_FAILURE() << "is accepted";
    } catch(const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("point 2 "), std::string::npos) << error.what();
    }
  }
}

TEST(Curve_network, refuses_more_points_than_it_can_number)
{
  using CGAL::Volume_filling_curves::internal::Curve_topology;
  const std::size_t count = std::size_t(1) << 32;
  EXPECT_THROW(Curve_topology(count, {}), std::length_error);
  EXPECT_THROW(Curve_topology(5 * count, {}), std::length_error);
}

TEST(Curve_network, may_be_empty)
{
  Network network;
  EXPECT_EQ(network.number_of_nodes() + network.number_of_edges() + network.number_of_components(),
            0u);
  Guard guard(network);
  EXPECT_TRUE(guard.collect_garbage().empty());
  EXPECT_EQ(guard.move_nodes(Targets(0, 3)), 1);
  EXPECT_FALSE(network.has_junction());
}

} // namespace test_curve_network_3
