// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_TOPOLOGY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_TOPOLOGY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The graph of a curve network, without coordinates: flat arrays with 32-bit indices. Inserting
// and removing a node is local, takes constant time and leaves gaps; `compact()` closes them and
// numbers the nodes along the curve again, component after component, so that neighbours lie next
// to each other in memory and components keep their order, orientation and, where it survives,
// their first node.
class Curve_topology
{
public:
  using Index = std::uint32_t;
  static constexpr std::size_t null = static_cast<Index>(-1);

  Curve_topology() : m_first_node(1, 0) {}

  Curve_topology(std::size_t number_of_points, const std::vector<std::array<std::size_t, 2>>& edges)
      : m_nodes(checked(number_of_points))
  {
    checked(edges.size());
    for(std::size_t v = 0; v < number_of_points; ++v) m_nodes[v].origin = narrow(v);
    for(const auto& edge : edges) add_edge(edge[0], edge[1]);
    label_components();
    compact();
  }

  std::size_t number_of_nodes() const { return m_nodes.size(); }
  std::size_t number_of_edges() const { return m_edges.size(); }
  std::size_t degree(std::size_t v) const { return m_nodes[v].edges.size(); }
  std::size_t incident_edge(std::size_t v, std::size_t k) const { return m_nodes[v].edges[k]; }
  std::size_t source(std::size_t e) const { return m_edges[e][0]; }
  std::size_t target(std::size_t e) const { return m_edges[e][1]; }
  std::size_t opposite(std::size_t v, std::size_t e) const
  {
    return m_edges[e][0] == v ? m_edges[e][1] : m_edges[e][0];
  }

  std::size_t origin(std::size_t v) const { return m_nodes[v].origin; }
  std::size_t component(std::size_t v) const { return m_nodes[v].component; }
  bool is_pinned(std::size_t v) const { return m_nodes[v].is_pinned; }
  void set_pinned(std::size_t v, bool is_pinned) { m_nodes[v].is_pinned = is_pinned; }

  std::size_t number_of_components() const { return m_first_node.size() - 1; }
  std::size_t first_node(std::size_t c) const { return m_first_node[c]; }
  bool is_closed(std::size_t c) const { return m_is_closed[c]; }
  bool has_junction() const
  {
    return std::find(m_has_junction.begin(), m_has_junction.end(), true) != m_has_junction.end();
  }

  bool are_adjacent(std::size_t v, std::size_t w) const
  {
    const auto& edges = m_nodes[v].edges;
    return std::any_of(edges.begin(), edges.end(), [&](Index e) { return opposite(v, e) == w; });
  }

  // A removed node has no edges, a removed edge joins null with null.
  bool is_removed_node(std::size_t v) const { return m_nodes[v].edges.empty(); }
  bool is_removed_edge(std::size_t e) const { return m_edges[e][0] == null; }

  // Since the last compact(): first nodes of components and numbers along the curve are out of date.
  bool has_garbage() const { return m_has_garbage; }

  // Splits edge e = (a, c) into e = (a, b) and a new last edge (b, c); b is the new last node.
  std::size_t insert_node(std::size_t e)
  {
    const Index b = narrow(checked(m_nodes.size() + 1) - 1);
    const Index f = narrow(checked(m_edges.size() + 1) - 1);
    m_has_garbage = true;
    const Index c = m_edges[e][1];
    Node node;
    node.component = m_nodes[c].component;
    node.edges = {narrow(e), f};
    m_nodes.push_back(std::move(node));
    m_edges.push_back({b, c});
    m_edges[e][1] = b;
    std::replace(m_nodes[c].edges.begin(), m_nodes[c].edges.end(), narrow(e), f);
    return b;
  }

  // Joins the edges e = (a, b) and f = (b, c) of node b into e = (a, c), and returns e.
  std::size_t remove_node(std::size_t b)
  {
    m_has_garbage = true;
    Index e = m_nodes[b].edges[0], f = m_nodes[b].edges[1];
    if(m_edges[e][1] != b) std::swap(e, f);
    const std::size_t c = opposite(b, f);
    m_edges[e][m_edges[e][0] == b ? 0 : 1] = narrow(c);
    std::replace(m_nodes[c].edges.begin(), m_nodes[c].edges.end(), f, e);
    m_edges[f] = {narrow(null), narrow(null)};
    m_nodes[b].edges.clear();
    return e;
  }

  // Lengthens a strand at its end v by an edge to a new last node, which is returned.
  std::size_t add_leaf(std::size_t v)
  {
    m_has_garbage = true;
    const Index leaf = narrow(m_nodes.size()), e = narrow(m_edges.size());
    const bool is_start = source(m_nodes[v].edges[0]) == v;
    Node node;
    node.component = m_nodes[v].component;
    node.edges = {e};
    m_nodes.push_back(std::move(node));
    m_nodes[v].edges.push_back(e);
    if(is_start)
      m_edges.push_back({leaf, narrow(v)});
    else
      m_edges.push_back({narrow(v), leaf});
    return leaf;
  }

  // Removes a node with one edge, and this edge. The other end of the edge has another one.
  void remove_leaf(std::size_t leaf)
  {
    m_has_garbage = true;
    const Index e = m_nodes[leaf].edges[0];
    auto& others = m_nodes[opposite(leaf, e)].edges;
    others.erase(std::find(others.begin(), others.end(), e));
    m_edges[e] = {narrow(null), narrow(null)};
    m_nodes[leaf].edges.clear();
  }

  // Returns the former index of each node.
  std::vector<Index> compact()
  {
    Walk walk(*this);
    for(Index start : walk_starts()) walk.run(start);
    std::vector<Node> nodes;
    nodes.reserve(walk.order.size());
    for(Index v : walk.order) {
      nodes.push_back(std::move(m_nodes[v]));
      nodes.back().edges.clear();
    }
    m_nodes = std::move(nodes);
    m_edges = std::move(walk.edges);
    connect();
    m_has_garbage = false;
    return std::move(walk.order);
  }

private:
  struct Node
  {
    boost::container::small_vector<Index, 2> edges;
    Index origin = narrow(null);
    Index component = narrow(null);
    bool is_pinned = false;
  };

  // Numbers nodes and edges depth first; along a strand the walk runs straight on, and it leaves a
  // node through an edge that starts there if there is one.
  struct Walk
  {
    explicit Walk(const Curve_topology& curve)
        : topology(curve),
          number(curve.number_of_nodes(), narrow(null)),
          is_used(curve.number_of_edges(), false)
    {
      order.reserve(curve.number_of_nodes());
      edges.reserve(curve.number_of_edges());
    }

    void run(Index start)
    {
      const bool is_curve = !topology.m_has_junction[topology.component(start)];
      visit(start);
      stack.assign(1, start);
      while(!stack.empty()) {
        const Index v = stack.back(), e = next_edge(v);
        if(e == null) {
          stack.pop_back();
          continue;
        }
        is_used[e] = true;
        const Index w = narrow(topology.opposite(v, e));
        if(number[w] == null) visit(w);
        if(is_curve || topology.source(e) == v)
          edges.push_back({number[v], number[w]});
        else
          edges.push_back({number[w], number[v]});
        stack.push_back(w);
      }
    }

    void visit(Index v)
    {
      number[v] = narrow(order.size());
      order.push_back(v);
    }

    Index next_edge(Index v) const
    {
      Index found = narrow(null);
      for(Index e : topology.m_nodes[v].edges) {
        if(is_used[e]) continue;
        if(topology.source(e) == v) return e;
        if(found == null) found = e;
      }
      return found;
    }

    const Curve_topology& topology;
    std::vector<Index> number, order, stack;
    std::vector<std::array<Index, 2>> edges;
    std::vector<bool> is_used;
  };

  static constexpr Index narrow(std::size_t i) { return static_cast<Index>(i); }

  // the largest index is null
  static std::size_t checked(std::size_t count)
  {
    if(count > null)
      throw std::length_error("a network has fewer than 2^32 nodes and edges, not " +
                              std::to_string(count));
    return count;
  }

  void add_edge(std::size_t a, std::size_t b)
  {
    const auto fail = [&](const char* what) {
      throw std::invalid_argument("edge (" + std::to_string(a) + ", " + std::to_string(b) + ") " +
                                  what);
    };
    if((std::max)(a, b) >= m_nodes.size()) fail("has no such node");
    if(a == b) fail("joins a node with itself");
    if(are_adjacent(a, b)) fail("occurs twice");
    m_nodes[a].edges.push_back(narrow(m_edges.size()));
    m_nodes[b].edges.push_back(narrow(m_edges.size()));
    m_edges.push_back({narrow(a), narrow(b)});
  }

  // Components are numbered in the order of their first edges.
  void label_components()
  {
    Index count = 0;
    for(const auto& edge : m_edges)
      if(m_nodes[edge[0]].component == null) label_component(edge[0], count++);
    m_first_node.assign(count + 1, 0);
    m_is_closed.assign(count, true);
    m_has_junction.assign(count, false);
    for(const Node& node : m_nodes) {
      if(node.edges.empty()) continue;
      if(node.edges.size() != 2) m_is_closed[node.component] = false;
      if(node.edges.size() > 2) m_has_junction[node.component] = true;
    }
  }

  void label_component(Index start, Index label)
  {
    std::vector<Index> stack(1, start);
    m_nodes[start].component = label;
    while(!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      for(Index e : m_nodes[v].edges) {
        const Index w = narrow(opposite(v, e));
        if(m_nodes[w].component != null) continue;
        m_nodes[w].component = label;
        stack.push_back(w);
      }
    }
  }

  // A closed curve is walked from its node with the lowest index, a path from an end, preferably
  // one that its edge leaves.
  std::vector<Index> walk_starts() const
  {
    std::vector<Index> starts(number_of_components(), narrow(null));
    const auto rank = [&](Index v) {
      if(v == null) return 3;
      if(degree(v) != 1) return 2;
      return source(m_nodes[v].edges[0]) == v ? 0 : 1;
    };
    for(Index v = 0; v < m_nodes.size(); ++v) {
      if(m_nodes[v].edges.empty()) continue;
      Index& start = starts[m_nodes[v].component];
      if(rank(v) < rank(start)) start = v;
    }
    return starts;
  }

  void connect()
  {
    for(Index e = 0; e < m_edges.size(); ++e)
      for(Index v : m_edges[e]) m_nodes[v].edges.push_back(e);
    m_first_node.assign(number_of_components() + 1, 0);
    for(const Node& node : m_nodes) ++m_first_node[node.component + 1];
    for(std::size_t c = 0; c < number_of_components(); ++c) m_first_node[c + 1] += m_first_node[c];
  }

  std::vector<Node> m_nodes;
  std::vector<std::array<Index, 2>> m_edges; // source and target
  std::vector<Index> m_first_node;           // per component, and the number of nodes at the end
  std::vector<bool> m_is_closed, m_has_junction;
  bool m_has_garbage = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_TOPOLOGY_H
