// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_POLYGON_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_POLYGON_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Dynamic_box_tree.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Working copy of a curve for a search that makes millions of small changes: flat arrays of doubles
// and the boxes of the edges, without allocation per change. Unpinned nodes with two edges can
// change; all others stay. Polygon_guard decides whether a change is allowed.
class Search_polygon
{
public:
  using Index = std::uint32_t;
  static constexpr Index null = static_cast<Index>(-1);

  template <typename Network>
  explicit Search_polygon(const Network& curve)
      : m_next_name(static_cast<Index>(curve.number_of_nodes()))
  {
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
      Node node;
      node.position = to_vector(curve.point(v));
      node.name = static_cast<Index>(v);
      node.component = static_cast<Index>(curve.component(v));
      node.is_fixed = curve.degree(v) != 2 || !curve.is_free(v);
      for(std::size_t k = 0; k < 2 && curve.degree(v) == 2; ++k)
        node.edges[k] = static_cast<Index>(curve.incident_edge(v, k));
      m_nodes.push_back(node);
    }
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      m_edges.push_back({static_cast<Index>(curve.source(e)), static_cast<Index>(curve.target(e))});
    m_edges_of_component.assign(curve.number_of_components(), 0);
    for(const Edge& edge : m_edges) ++m_edges_of_component[m_nodes[edge.source].component];
    renumber();
  }

  // Nodes that may move are 0, ..., number_of_free_nodes() - 1 of this list, in no special order.
  std::size_t number_of_free_nodes() const { return m_free.size(); }
  Index free_node(std::size_t k) const { return m_free[k]; }

  // the number of nodes, including those removed since the last `renumber()`
  std::size_t number_of_nodes() const { return m_nodes.size(); }

  std::size_t number_of_edges() const { return m_number_of_edges; }
  const std::vector<Index>& edges_of_component() const { return m_edges_of_component; }
  const Vector& position(Index v) const { return m_nodes[v].position; }
  Index edge(Index v, std::size_t k) const { return m_nodes[v].edges[k]; }
  Index neighbor(Index v, std::size_t k) const { return opposite(m_nodes[v].edges[k], v); }
  Index source(Index e) const { return m_edges[e].source; }
  Index target(Index e) const { return m_edges[e].target; }

  // The number that Isotopy_guard_3 gives node v: its number in the input; inserted nodes get the
  // next numbers in the order of insertion.
  Index name(Index v) const { return m_nodes[v].name; }

  // Calls f(e) for every edge.
  template <typename Function>
  void for_each_edge(const Function& f) const
  {
    for(Index e = 0; e < m_edges.size(); ++e)
      if(m_edges[e].source != null) f(e);
  }

  // Calls f(e) for every edge whose box overlaps `box`, and for some whose box nearly does, until f
  // returns false. Returns whether all calls returned true.
  template <typename Function>
  bool holds_near(const Box& box, const Function& f) const
  {
    return m_boxes.holds_near(box, [&](std::size_t e) { return f(static_cast<Index>(e)); });
  }

  void move_node(Index v, const Vector& target)
  {
    m_nodes[v].position = target;
    update_box(m_nodes[v].edges[0]);
    update_box(m_nodes[v].edges[1]);
  }

  // \pre v is a free node
  void remove_node(Index v)
  {
    const Node& node = m_nodes[v];
    const Index c = neighbor(v, 1), e = node.edges[0], f = node.edges[1];
    replace_end(e, v, c);
    replace_edge(c, f, e);
    m_edges[f] = {null, null};
    m_boxes.clear(f);
    update_box(e);
    m_unused_edges.push_back(f);
    m_unused_nodes.push_back(v);
    --m_edges_of_component[node.component];
    --m_number_of_edges;
    const Index last = m_free.back(), free_index = node.free_index;
    m_free[free_index] = last;
    m_nodes[last].free_index = free_index;
    m_free.pop_back();
  }

  // inserts a node at p in edge e
  void insert_node(Index e, const Vector& p)
  {
    const Index a = m_edges[e].source, c = m_edges[e].target;
    const Index v = new_node(), f = new_edge();
    Node& node = m_nodes[v];
    node.position = p;
    node.name = m_next_name++;
    node.component = m_nodes[a].component;
    node.is_fixed = false;
    node.edges = {e, f};
    node.free_index = static_cast<Index>(m_free.size());
    m_free.push_back(v);
    m_edges[e] = {a, v};
    m_edges[f] = {v, c};
    replace_edge(c, e, f);
    update_box(e);
    update_box(f);
    ++m_edges_of_component[node.component];
    ++m_number_of_edges;
  }

  // Closes the gaps that removed nodes left. Indices of nodes and edges change.
  void renumber()
  {
    const std::vector<Index> node_numbers = renumber_nodes();
    const std::vector<Index> edge_numbers = renumber_edges(node_numbers);
    m_free.clear();
    for(Index v = 0; v < m_nodes.size(); ++v) {
      if(m_nodes[v].edges[0] != null)
        for(Index& e : m_nodes[v].edges) e = edge_numbers[e];
      if(m_nodes[v].is_fixed) continue;
      m_nodes[v].free_index = static_cast<Index>(m_free.size());
      m_free.push_back(v);
    }
    collect_boxes();
  }

private:
  struct Node
  {
    Vector position;
    std::array<Index, 2> edges = {null, null};     // only of nodes with two
    Index name = 0, component = 0, free_index = 0; // free_index: in m_free
    bool is_fixed = false;
  };

  struct Edge
  {
    Index source, target;
  };

  Index opposite(Index e, Index v) const
  {
    return m_edges[e].source == v ? m_edges[e].target : m_edges[e].source;
  }

  void replace_end(Index e, Index from, Index to)
  {
    (m_edges[e].source == from ? m_edges[e].source : m_edges[e].target) = to;
  }

  void replace_edge(Index v, Index from, Index to)
  {
    for(Index& e : m_nodes[v].edges)
      if(e == from) e = to;
  }

  Index new_node()
  {
    if(m_unused_nodes.empty()) {
      m_nodes.emplace_back();
      return static_cast<Index>(m_nodes.size() - 1);
    }
    const Index v = m_unused_nodes.back();
    m_unused_nodes.pop_back();
    return v;
  }

  Index new_edge()
  {
    if(m_unused_edges.empty()) {
      m_edges.push_back({null, null});
      return static_cast<Index>(m_edges.size() - 1);
    }
    const Index e = m_unused_edges.back();
    m_unused_edges.pop_back();
    return e;
  }

  // Each returns the new numbers; null for removed elements.

  std::vector<Index> renumber_nodes()
  {
    std::vector<Index> numbers(m_nodes.size(), 0);
    for(Index v : m_unused_nodes) numbers[v] = null;
    m_unused_nodes.clear();
    Index n = 0;
    for(Index v = 0; v < m_nodes.size(); ++v) {
      if(numbers[v] == null) continue;
      numbers[v] = n;
      m_nodes[n++] = m_nodes[v];
    }
    m_nodes.resize(n);
    return numbers;
  }

  std::vector<Index> renumber_edges(const std::vector<Index>& node_numbers)
  {
    std::vector<Index> numbers(m_edges.size(), null);
    Index n = 0;
    for_each_edge([&](Index e) {
      numbers[e] = n;
      m_edges[n++] = {node_numbers[m_edges[e].source], node_numbers[m_edges[e].target]};
    });
    m_unused_edges.clear();
    m_edges.resize(n);
    m_number_of_edges = n;
    return numbers;
  }

  void update_box(Index e)
  {
    m_boxes.set(
        e, Box(m_nodes[m_edges[e].source].position).extend(m_nodes[m_edges[e].target].position));
  }

  void collect_boxes()
  {
    Box frame;
    for(const Node& node : m_nodes) frame.extend(node.position);
    m_boxes = Dynamic_box_tree(frame);
    for(Index e = 0; e < m_edges.size(); ++e) update_box(e);
  }

  std::vector<Node> m_nodes;
  std::vector<Edge> m_edges; // null if unused
  std::vector<Index> m_free, m_unused_nodes, m_unused_edges;
  std::vector<Index> m_edges_of_component;
  std::size_t m_number_of_edges = 0;
  Index m_next_name;
  Dynamic_box_tree m_boxes;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_POLYGON_H
