// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

// Notifications suffice to follow every change of a network.
namespace test_observers {

using namespace guard_test;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
using Point = Network::Point_3;

// Own nodes and edges, updated only by notifications.
class Mirror final : public CGAL::Volume_filling_curves::Curve_network_observer_3<>
{
public:
  explicit Mirror(const Network& network) : m_network(network)
  {
    for(std::size_t v = 0; v < network.number_of_nodes(); ++v) m_points.push_back(network.point(v));
    for(std::size_t e = 0; e < network.number_of_edges(); ++e)
      add_edge(network.source(e), network.target(e));
  }

  void on_move(std::size_t v) override { m_points[v] = m_network.point(v); }

  void on_motion(const std::vector<Point>& before, const Rounds& rounds) override
  {
    EXPECT_EQ(before, m_points);
    m_points = rounds.positions.back();
  }

  void on_insertion(std::size_t v) override
  {
    const std::size_t a = m_network.neighbor(v, 0), c = m_network.neighbor(v, 1);
    EXPECT_EQ(v, m_points.size());
    m_edges.erase(std::minmax(a, c));
    add_edge(a, v);
    add_edge(v, c);
    m_points.push_back(m_network.point(v));
  }

  void on_removal(std::size_t v, std::size_t e) override
  {
    m_edges.erase(std::minmax(v, m_network.source(e)));
    m_edges.erase(std::minmax(v, m_network.target(e)));
    add_edge(m_network.source(e), m_network.target(e));
  }

  void on_new_ray(std::size_t v) override
  {
    m_points.push_back(m_network.point(v));
    add_edge(m_network.neighbor(v, 0), v);
  }

  void on_shorter_ray(std::size_t v, std::size_t) override
  {
    for(auto edge = m_edges.begin(); edge != m_edges.end();)
      edge = edge->first == v || edge->second == v ? m_edges.erase(edge) : std::next(edge);
  }

  void on_renumbering(const std::vector<std::uint32_t>& former) override
  {
    std::vector<Point> points;
    std::vector<std::size_t> numbers(m_points.size());
    for(const std::uint32_t v : former) {
      numbers[v] = points.size();
      points.push_back(m_points[v]);
    }
    m_points = points;
    for(const auto& [v, w] : std::exchange(m_edges, {})) add_edge(numbers[v], numbers[w]);
  }

  void expect_equal() const
  {
    std::set<std::pair<std::size_t, std::size_t>> edges;
    for(const std::size_t e : m_network.edges())
      edges.insert(std::minmax(m_network.source(e), m_network.target(e)));
    EXPECT_EQ(m_edges, edges);
    ASSERT_EQ(m_points.size(), number_of_node_indices(m_network));
    for(std::size_t v = 0; v < m_points.size(); ++v) EXPECT_EQ(m_points[v], m_network.point(v));
  }

private:
  void add_edge(std::size_t v, std::size_t w) { m_edges.insert(std::minmax(v, w)); }

  const Network& m_network;
  std::vector<Point> m_points;
  std::set<std::pair<std::size_t, std::size_t>> m_edges;
};

Network path()
{
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(3, 0, 0)},
          {{0, 1}, {1, 2}, {2, 3}}};
}

TEST(Observers, hear_of_every_change)
{
  Network network = path();
  Guard guard(network);
  Mirror mirror(network);
  guard.add_observer(mirror);
  EXPECT_TRUE(guard.move_node(1, Point(1, 1, 0)));
  mirror.expect_equal();
  EXPECT_TRUE(guard.insert_node(1, Point(1.5, 1, 0)));
  mirror.expect_equal();
  EXPECT_TRUE(guard.add_ray(3, Point(4, 0, 0)));
  mirror.expect_equal();
  EXPECT_TRUE(network.is_pinned(5));
  EXPECT_TRUE(guard.remove_node(2));
  mirror.expect_equal();
  EXPECT_EQ(guard.collect_garbage().size(), 5u);
  mirror.expect_equal();
  Targets targets = CGAL::Volume_filling_curves::internal::coordinates(network);
  targets.col(2).setConstant(7);
  EXPECT_EQ(guard.move_nodes(targets), 1);
  mirror.expect_equal();
  targets.col(0).array() += 1;
  EXPECT_EQ(guard.advance_nodes(targets), std::vector<double>(5, 1));
  mirror.expect_equal();
  guard.remove_rays();
  mirror.expect_equal();
  EXPECT_EQ(network.number_of_nodes(), 4u);
}

TEST(Observers, can_be_removed_without_having_been_added)
{
  Network network = path();
  Guard guard(network);
  Mirror mirror(network);
  guard.remove_observer(mirror);
  EXPECT_TRUE(guard.move_node(1, Point(1, 1, 0)));
}

TEST(Observers, hear_nothing_once_removed)
{
  Network network = path();
  Guard guard(network);
  Mirror stays(network), leaves(network);
  guard.add_observer(stays);
  guard.add_observer(leaves);
  guard.remove_observer(leaves);
  EXPECT_TRUE(guard.insert_node(0, Point(0.5, 0, 0)));
  stays.expect_equal();
}

} // namespace test_observers
