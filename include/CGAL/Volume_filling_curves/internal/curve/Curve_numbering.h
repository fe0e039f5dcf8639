// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NUMBERING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NUMBERING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Components of a network: whether they are closed and have junctions, which never changes, and
// their nodes since the last numbering.
class Curve_components
{
public:
  Curve_components() : m_first_node(1, 0) {}

  std::size_t count() const { return m_is_closed.size(); }
  std::size_t first_node(std::size_t c) const { return m_first_node[c]; }
  bool is_closed(std::size_t c) const { return m_is_closed[c]; }
  bool has_junction(std::size_t c) const { return m_has_junction[c]; }
  bool has_junction() const
  {
    return std::find(m_has_junction.begin(), m_has_junction.end(), true) != m_has_junction.end();
  }

  // A node of component c has this number of edges.
  void note_degree(std::size_t c, std::size_t degree)
  {
    if(c >= count()) {
      m_is_closed.resize(c + 1, true);
      m_has_junction.resize(c + 1, false);
    }
    if(degree != 2) m_is_closed[c] = false;
    if(degree > 2) m_has_junction[c] = true;
  }

  // Takes the nodes in the order of the components.
  template <typename Nodes>
  void number(const Nodes& nodes)
  {
    m_first_node.assign(count() + 1, 0);
    for(const auto& node : nodes) ++m_first_node[node.component + 1];
    for(std::size_t c = 0; c < count(); ++c) m_first_node[c + 1] += m_first_node[c];
  }

private:
  std::vector<std::uint32_t> m_first_node; // per component, and the number of nodes at the end
  std::vector<bool> m_is_closed, m_has_junction;
};

// Numbers for the nodes and edges that a network has, without gaps.
struct Curve_numbering
{
  using Index = std::uint32_t;

  std::vector<Index> former_nodes, former_edges; // the former index of each
  std::vector<std::array<Index, 2>> edges;       // source and target of each, as they are now
};

// Numbers nodes and edges along the curve, component after component, so that neighbors lie next to
// each other in memory: depth first; along a strand the walk runs straight on, and it leaves a node
// through an edge that starts there if there is one. Linear time.
template <typename Topology>
class Numbering_walk
{
  using Index = Curve_numbering::Index;

public:
  explicit Numbering_walk(const Topology& topology)
      : m_topology(topology),
        m_number(topology.number_of_nodes() + topology.number_of_removed_nodes(), null),
        m_is_used(topology.number_of_edges() + topology.number_of_removed_edges(), false)
  {
    m_result.former_nodes.reserve(topology.number_of_nodes());
    m_result.former_edges.reserve(topology.number_of_edges());
    m_result.edges.reserve(topology.number_of_edges());
  }

  Curve_numbering operator()()
  {
    for(const Index start : starts()) walk_from(start);
    return std::move(m_result);
  }

private:
  static constexpr Index null = static_cast<Index>(Topology::null);

  static Index narrow(std::size_t i) { return static_cast<Index>(i); }

  // A closed curve is walked from its node with the lowest index, a path from an end, preferably
  // one that its edge leaves.
  std::vector<Index> starts() const
  {
    std::vector<Index> starts(m_topology.number_of_components(), null);
    for(Index v = 0; v < m_number.size(); ++v) {
      if(m_topology.is_removed_node(v)) continue;
      Index& start = starts[m_topology.component(v)];
      if(rank(v) < rank(start)) start = v;
    }
    return starts;
  }

  int rank(Index v) const
  {
    if(v == null) return 3;
    if(m_topology.degree(v) != 1) return 2;
    return m_topology.source(m_topology.incident_edge(v, 0)) == v ? 0 : 1;
  }

  void walk_from(Index start)
  {
    const bool is_curve = !m_topology.has_junction(m_topology.component(start));
    visit(start);
    m_stack.assign(1, start);
    while(!m_stack.empty()) {
      const Index v = m_stack.back(), e = next_edge(v);
      if(e == null) {
        m_stack.pop_back();
        continue;
      }
      m_is_used[e] = true;
      m_result.former_edges.push_back(e);
      const Index w = narrow(m_topology.opposite(v, e));
      if(m_number[w] == null) visit(w);
      if(is_curve || m_topology.source(e) == v)
        m_result.edges.push_back({m_number[v], m_number[w]});
      else
        m_result.edges.push_back({m_number[w], m_number[v]});
      m_stack.push_back(w);
    }
  }

  void visit(Index v)
  {
    m_number[v] = narrow(m_result.former_nodes.size());
    m_result.former_nodes.push_back(v);
  }

  Index next_edge(Index v) const
  {
    Index found = null;
    for(std::size_t k = 0; k < m_topology.degree(v); ++k) {
      const Index e = narrow(m_topology.incident_edge(v, k));
      if(m_is_used[e]) continue;
      if(m_topology.source(e) == v) return e;
      if(found == null) found = e;
    }
    return found;
  }

  const Topology& m_topology;
  Curve_numbering m_result;
  std::vector<Index> m_number; // per node, as it was
  std::vector<bool> m_is_used; // per edge, as it was
  std::vector<Index> m_stack;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NUMBERING_H
