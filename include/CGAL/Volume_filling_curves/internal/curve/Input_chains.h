// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_INPUT_CHAINS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_INPUT_CHAINS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Chains of the input, from which the origins of a result's nodes are found. A chain consists of
// the input's nodes from one end or junction to the next, in order. A component without junctions
// is one chain, closed or open. 4 bytes per node.
class Input_chains
{
public:
  using Index = std::uint32_t;

  // The chain that an edge is a part of, and whether the edge runs against it.
  struct Label
  {
    static constexpr Index none = static_cast<Index>(-1);

    Index chain = none;
    Index is_reversed = 0; // or 1
  };

  Input_chains() : m_first_node(1, 0), m_first_chain(1, 0) {}

  template <typename Topology>
  explicit Input_chains(const Topology& topology) : Input_chains()
  {
    if(topology.has_junction()) m_labels.resize(topology.number_of_edges());
    for(std::size_t c = 0; c < topology.number_of_components(); ++c) {
      if(topology.has_junction(c))
        add_chains_between_junctions(topology, c);
      else
        add_component(topology, c);
      m_first_chain.push_back(static_cast<Index>(m_first_node.size() - 1));
    }
  }

  // the first chain of a component
  std::size_t first_chain(std::size_t c) const { return m_first_chain[c]; }

  // the number of nodes of a chain, in which a closed one does not repeat its first
  std::size_t size(std::size_t chain) const
  {
    return m_first_node[chain + 1] - m_first_node[chain];
  }

  // the index in the input of a node
  std::size_t node(std::size_t chain, std::size_t rank) const
  {
    return m_nodes[m_first_node[chain] + rank];
  }

  // The label of an edge. There are labels only where there are junctions, since otherwise each
  // component is one chain.
  Label label(std::size_t e) const { return m_labels[e]; }

  // There is a new last edge: a part of edge e, or none of the input.
  void add_part_of(std::size_t e)
  {
    if(!m_labels.empty()) m_labels.push_back(m_labels[e]);
  }

  void add_foreign()
  {
    if(!m_labels.empty()) m_labels.emplace_back();
  }

  // Edges were renumbered: edge e had the index former[e].
  void renumber(const std::vector<Index>& former)
  {
    if(m_labels.empty()) return;
    std::vector<Label> labels;
    labels.reserve(former.size());
    for(const Index e : former) labels.push_back(m_labels[e]);
    m_labels = std::move(labels);
  }

  // one per edge, or none at all
  const std::vector<Label>& labels() const { return m_labels; }

  // Edges were replaced. \throws std::invalid_argument if the labels are those of other chains
  void relabel(std::size_t number_of_edges, const std::vector<Label>& labels)
  {
    const auto is_known = [this](const Label& label) {
      return label.chain == Label::none || label.chain + 1 < m_first_node.size();
    };
    if(labels.size() != (m_labels.empty() ? 0 : number_of_edges) ||
       !std::all_of(labels.begin(), labels.end(), is_known))
      throw std::invalid_argument("edges come from another input");
    m_labels = labels;
  }

  // returns a number that is larger than that of every node of the input
  std::size_t end_of_nodes() const
  {
    return m_nodes.empty() ? 0 : *std::max_element(m_nodes.begin(), m_nodes.end()) + std::size_t(1);
  }

private:
  template <typename Topology>
  void add_component(const Topology& topology, std::size_t c)
  {
    for(std::size_t v = topology.first_node(c); v < topology.first_node(c + 1); ++v)
      add_node(topology, v);
    end_chain();
  }

  template <typename Topology>
  void add_chains_between_junctions(const Topology& topology, std::size_t c)
  {
    for(std::size_t v = topology.first_node(c); v < topology.first_node(c + 1); ++v) {
      if(topology.degree(v) == 2) continue;
      for(std::size_t k = 0; k < topology.degree(v); ++k)
        if(m_labels[topology.incident_edge(v, k)].chain == Label::none)
          add_chain(topology, v, topology.incident_edge(v, k));
    }
  }

  // Walks from junction or end v along edge e to the next one.
  template <typename Topology>
  void add_chain(const Topology& topology, std::size_t v, std::size_t e)
  {
    const Index chain = static_cast<Index>(m_first_node.size() - 1);
    add_node(topology, v);
    for(;;) {
      m_labels[e] = {chain, topology.source(e) != v};
      v = topology.opposite(v, e);
      add_node(topology, v);
      if(topology.degree(v) != 2) return end_chain();
      e = topology.incident_edge(v, topology.incident_edge(v, 0) == e ? 1 : 0);
    }
  }

  template <typename Topology>
  void add_node(const Topology& topology, std::size_t v)
  {
    m_nodes.push_back(static_cast<Index>(topology.origin(v)));
  }

  void end_chain() { m_first_node.push_back(static_cast<Index>(m_nodes.size())); }

  std::vector<Index> m_nodes;       // of the chains one after the other
  std::vector<Index> m_first_node;  // per chain, and the number of nodes at the end
  std::vector<Index> m_first_chain; // per component, and the number of chains at the end
  std::vector<Label> m_labels;      // per edge, if there are junctions
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_INPUT_CHAINS_H
