// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_TOPOLOGY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_TOPOLOGY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_numbering.h>
#include <CGAL/Volume_filling_curves/internal/curve/Input_chains.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Graph of a curve network, without coordinates: flat arrays with 32-bit indices. Inserting and
// removing a node is local, takes constant time and leaves gaps. `compact()` closes the gaps and
// renumbers the nodes along the curve; components keep their order, orientation and, if it still
// exists, their first node.
class Curve_topology
{
public:
  using Index = Curve_numbering::Index;
  static constexpr std::size_t null = static_cast<Index>(-1);

  Curve_topology() = default;

  Curve_topology(std::size_t number_of_points, const std::vector<std::array<std::size_t, 2>>& edges)
      : m_nodes(checked(number_of_points))
  {
    checked(edges.size());
    for(std::size_t v = 0; v < number_of_points; ++v) m_nodes[v].origin = narrow(v);
    for(const auto& edge : edges) add_edge(edge[0], edge[1]);
    label_components(edges);
    compact();
    m_input = Input_chains(*this);
  }

  // Removed nodes and edges, which keep their indices until they are collected, do not count.
  std::size_t number_of_nodes() const { return m_nodes.size() - m_number_of_removed_nodes; }
  std::size_t number_of_edges() const { return m_edges.size() - m_number_of_removed_edges; }
  std::size_t number_of_removed_nodes() const { return m_number_of_removed_nodes; }
  std::size_t number_of_removed_edges() const { return m_number_of_removed_edges; }

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

  const Node_constraint& constraint(std::size_t v) const
  {
    return m_constraints[m_nodes[v].constraint];
  }

  bool is_free(std::size_t v) const { return m_nodes[v].constraint == free; }
  bool is_fixed(std::size_t v) const { return m_nodes[v].constraint == fixed; }
  void set_fixed(std::size_t v, bool is_fixed) { m_nodes[v].constraint = is_fixed ? fixed : free; }

  // Linear in the number of different constraints.
  void set_constraint(std::size_t v, const Node_constraint& constraint)
  {
    const auto known = std::find(m_constraints.begin(), m_constraints.end(), constraint);
    m_nodes[v].constraint = narrow(static_cast<std::size_t>(known - m_constraints.begin()));
    if(known == m_constraints.end()) m_constraints.push_back(constraint);
  }

  std::size_t number_of_components() const { return m_components.count(); }
  std::size_t first_node(std::size_t c) const { return m_components.first_node(c); }
  bool is_closed(std::size_t c) const { return m_components.is_closed(c); }
  bool has_junction() const { return m_components.has_junction(); }
  bool has_junction(std::size_t c) const { return m_components.has_junction(c); }

  // the curves of the input, for the origins of nodes
  const Input_chains& input() const { return m_input; }

  bool are_adjacent(std::size_t v, std::size_t w) const
  {
    const auto& edges = m_nodes[v].edges;
    return std::any_of(edges.begin(), edges.end(), [&](Index e) { return opposite(v, e) == w; });
  }

  // A removed node has no edges, a removed edge joins null with null.
  bool is_removed_node(std::size_t v) const { return m_nodes[v].edges.empty(); }
  bool is_removed_edge(std::size_t e) const { return m_edges[e][0] == null; }

  // Since the last compact(): first nodes of components and numbers along the curve are out of
  // date.
  bool has_garbage() const { return m_has_garbage; }

  // Whether the node has two edges, and no constraint is lost with it.
  bool is_removable(std::size_t v) const
  {
    if(degree(v) != 2) return false;
    if(is_free(v)) return true;
    const std::size_t a = opposite(v, incident_edge(v, 0)), c = opposite(v, incident_edge(v, 1));
    return m_nodes[v].constraint == constraint_between(a, c);
  }

  // Splits edge e = (a, c) into e = (a, b) and a new last edge (b, c); b is the new last node, and
  // may slide like a and c.
  std::size_t insert_node(std::size_t e)
  {
    const Index b = narrow(checked(m_nodes.size() + 1) - 1);
    const Index f = narrow(checked(m_edges.size() + 1) - 1);
    m_has_garbage = true;
    const Index a = m_edges[e][0], c = m_edges[e][1];
    Node node;
    node.constraint = constraint_between(a, c);
    node.component = m_nodes[c].component;
    node.edges = {narrow(e), f};
    m_nodes.push_back(std::move(node));
    m_edges.push_back({b, c});
    m_edges[e][1] = b;
    std::replace(m_nodes[c].edges.begin(), m_nodes[c].edges.end(), narrow(e), f);
    m_input.add_part_of(e);
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
    mark_removed(b, f);
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
    m_input.add_foreign();
    return leaf;
  }

  // Removes a node with one edge, and this edge. The other end of the edge has another one.
  void remove_leaf(std::size_t leaf)
  {
    m_has_garbage = true;
    const Index e = m_nodes[leaf].edges[0];
    auto& others = m_nodes[opposite(leaf, e)].edges;
    others.erase(std::find(others.begin(), others.end(), e));
    mark_removed(leaf, e);
  }

  // Returns the former index of each node.
  std::vector<Index> compact()
  {
    Curve_numbering numbering = Numbering_walk<Curve_topology>(*this)();
    std::vector<Node> nodes;
    nodes.reserve(numbering.former_nodes.size());
    for(Index v : numbering.former_nodes) {
      nodes.push_back(std::move(m_nodes[v]));
      nodes.back().edges.clear();
    }
    m_nodes = std::move(nodes);
    m_edges = std::move(numbering.edges);
    m_input.renumber(numbering.former_edges);
    connect();
    m_number_of_removed_nodes = m_number_of_removed_edges = 0;
    m_has_garbage = false;
    return std::move(numbering.former_nodes);
  }

  // Returns the topology of curves that have come from the same input, without garbage: takes their
  // edges, for each node its origin, and the labels of Input_chains.
  // \throws std::invalid_argument if these do not fit together
  Curve_topology with_edges(const std::vector<std::array<std::size_t, 2>>& edges,
                            const std::vector<std::size_t>& origins,
                            const std::vector<Input_chains::Label>& labels) const
  {
    Curve_topology result(origins.size(), edges);
    const std::size_t end = m_input.end_of_nodes();
    const auto is_origin = [end](std::size_t v) { return v == null || v < end; };
    bool is_consistent = result.number_of_nodes() == origins.size() &&
                         result.number_of_components() == number_of_components() &&
                         result.has_junction() == has_junction() &&
                         std::all_of(origins.begin(), origins.end(), is_origin);
    for(std::size_t e = 0; e < edges.size(); ++e)
      is_consistent &= edges[e] == std::array<std::size_t, 2>{result.source(e), result.target(e)};
    if(!is_consistent) throw std::invalid_argument("it is not numbered, or has another input");
    for(std::size_t v = 0; v < origins.size(); ++v) result.m_nodes[v].origin = narrow(origins[v]);
    result.m_input = m_input;
    result.m_input.relabel(edges.size(), labels);
    return result;
  }

private:
  static constexpr Index free = 0, fixed = 1; // the first constraints in the list

  struct Node
  {
    boost::container::small_vector<Index, 2> edges;
    Index origin = narrow(null);
    Index component = narrow(null);
    Index constraint = free; // in the list of constraints
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

  // The constraint of a node inserted between two others: that of the one that slides, if the other
  // one slides on the same set or is fixed.
  Index constraint_between(std::size_t v, std::size_t w) const
  {
    const Index a = m_nodes[v].constraint, b = m_nodes[w].constraint;
    if(a == fixed) return b == fixed ? free : b;
    return a == b || b == fixed ? a : free;
  }

  void mark_removed(std::size_t v, std::size_t e)
  {
    m_nodes[v].edges.clear();
    m_edges[e] = {narrow(null), narrow(null)};
    ++m_number_of_removed_nodes;
    ++m_number_of_removed_edges;
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
  void label_components(const std::vector<std::array<std::size_t, 2>>& edges)
  {
    const std::vector<std::size_t> numbers = component_numbers(m_nodes.size(), edges); // from 1
    for(std::size_t v = 0; v < m_nodes.size(); ++v) {
      if(numbers[v] == 0) continue;
      m_nodes[v].component = narrow(numbers[v] - 1);
      m_components.note_degree(m_nodes[v].component, degree(v));
    }
  }

  void connect()
  {
    for(Index e = 0; e < m_edges.size(); ++e)
      for(Index v : m_edges[e]) m_nodes[v].edges.push_back(e);
    m_components.number(m_nodes);
  }

  std::vector<Node> m_nodes;
  std::vector<Node_constraint> m_constraints = {Node_constraint(), Node_constraint::fixed()};
  std::vector<std::array<Index, 2>> m_edges; // source and target
  Curve_components m_components;
  Input_chains m_input;
  std::size_t m_number_of_removed_nodes = 0, m_number_of_removed_edges = 0;
  bool m_has_garbage = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_TOPOLOGY_H
