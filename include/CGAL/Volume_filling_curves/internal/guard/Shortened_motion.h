// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_SHORTENED_MOTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_SHORTENED_MOTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_observer_3.h>
#include <CGAL/Volume_filling_curves/internal/guard/Certified_motion.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Motion of all nodes in which each moves as far as nearby nodes allow: only nodes that block one
// another move half of their displacement, a quarter, ..., or stay. A tight spot then does not stop
// a whole curve, as it would if all nodes moved the same fraction.
//
// A test of a pair of edges or of a node reads the end positions of its nodes; hence all tests
// passed since the nodes were last shortened certify the whole motion. After the first round only
// tests near shortened nodes are repeated, and a node is shortened at most seven times: near-linear
// in the number of edges and candidate pairs. Tests run in parallel with a parallel tag.
template <typename Limits, typename ConcurrencyTag>
class Shortened_motion
{
  using Point_3 = typename Limits::Point_3;
  using Swept = typename Limits::Swept;
  using Index = std::uint32_t;
  using Indices = std::vector<Index>;

public:
  using Rounds = typename Certified_motion<Limits, ConcurrencyTag>::Rounds;

  explicit Shortened_motion(const Limits& limits, Run_watch* watch = nullptr)
      : m_limits(limits),
        m_watch(watch),
        m_start(limits.template positions<ConcurrencyTag>(0)),
        m_end(limits.template positions<ConcurrencyTag>(1)),
        m_swept(limits.curve(), m_start, m_end, false),
        m_fractions(m_end.size(), 1)
  {}

  // Determines how far the nodes can move, and returns the certified rounds.
  Rounds operator()()
  {
    Indices blocked = blocked_nodes();
    if(blocked.empty()) return one_round();
    // strands that travel together, farther than their distance, fail in one round
    Rounds rounds = Certified_motion<Limits, ConcurrencyTag>(m_limits, m_watch).certify(1);
    if(!rounds.positions.empty()) return rounds;
    sort_pairs_by_edges();
    while(!blocked.empty()) {
      for(const Index v : blocked) shorten(v);
      blocked = blocked_nodes_near(blocked);
    }
    return one_round();
  }

  // the fraction of its displacement that each node moves
  const std::vector<double>& fractions() const { return m_fractions; }

private:
  static constexpr double min_fraction = 1. / 64; // a node that cannot move so far stays
  static constexpr std::size_t block = 128;       // nodes or pairs per task

  Rounds one_round() { return {{std::move(m_end)}, false}; }

  bool is_pair_free(std::size_t k) const
  {
    return m_limits.is_pair_clear(k, m_end) && m_limits.is_pair_safe(k, m_swept);
  }

  bool is_node_free(std::size_t v) const
  {
    return m_limits.is_corner_clear(v, m_end) && m_limits.is_node_safe(v, m_swept);
  }

  Indices blocked_nodes()
  {
    const Indices pairs =
        failing(m_limits.number_of_pairs(), [this](std::size_t k) { return is_pair_free(k); });
    const Indices nodes =
        failing(m_start.size(), [this](std::size_t v) { return is_node_free(v); });
    return nodes_of(pairs, nodes);
  }

  // Near nodes that were shortened.
  Indices blocked_nodes_near(const Indices& shortened)
  {
    const auto& curve = m_limits.curve();
    Indices pairs, nodes; // each once
    for(const Index v : shortened) {
      add_node(v, nodes);
      for(std::size_t i = 0; i < curve.degree(v); ++i) {
        add_node(curve.neighbor(v, i), nodes);
        add_pairs(curve.incident_edge(v, i), pairs);
      }
    }
    ++m_round;
    return nodes_of(failing_of(pairs, [this](Index k) { return is_pair_free(k); }),
                    failing_of(nodes, [this](Index v) { return is_node_free(v); }));
  }

  template <typename Test>
  Indices failing_of(const Indices& candidates, const Test& passes) const
  {
    Indices found =
        failing(candidates.size(), [&](std::size_t i) { return passes(candidates[i]); });
    for(Index& i : found) i = candidates[i];
    return found;
  }

  // Returns the indices below n for which a test fails.
  template <typename Test>
  Indices failing(std::size_t n, const Test& passes) const
  {
    std::vector<Indices> found((n + block - 1) / block);
    for_each_block<ConcurrencyTag>(n, block, m_watch, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        if(!passes(k)) found[begin / block].push_back(static_cast<Index>(k));
    });
    Indices all;
    for(const Indices& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
  }

  void add_node(std::size_t v, Indices& nodes)
  {
    if(std::exchange(m_round_of_node[v], m_round) != m_round)
      nodes.push_back(static_cast<Index>(v));
  }

  void add_pairs(std::size_t e, Indices& pairs)
  {
    for(std::size_t i = m_first_pair[e]; i < m_first_pair[e + 1]; ++i) {
      const Index k = m_pairs_of_edges[i];
      if(std::exchange(m_round_of_pair[k], m_round) != m_round) pairs.push_back(k);
    }
  }

  // Returns the ends of pairs of edges, and nodes with their neighbors, each once, except for nodes
  // that stay.
  Indices nodes_of(const Indices& pairs, const Indices& corners) const
  {
    const auto& curve = m_limits.curve();
    Indices nodes;
    const auto add = [&](std::size_t v) {
      if(to_vector(m_start[v]) != to_vector(m_end[v])) nodes.push_back(static_cast<Index>(v));
    };
    for(const Index k : pairs)
      for(const std::size_t e : m_limits.pair(k)) {
        add(curve.source(e));
        add(curve.target(e));
      }
    for(const Index v : corners) {
      add(v);
      for(std::size_t i = 0; i < curve.degree(v); ++i) add(curve.neighbor(v, i));
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  void shorten(std::size_t v)
  {
    m_fractions[v] = m_fractions[v] > min_fraction ? m_fractions[v] / 2 : 0;
    m_end[v] = m_limits.position(v, m_fractions[v]);
  }

  // Groups the pairs by their edges, each pair twice.
  void sort_pairs_by_edges()
  {
    m_first_pair.assign(m_limits.curve().number_of_edges() + 1, 0);
    for(std::size_t k = 0; k < m_limits.number_of_pairs(); ++k)
      for(const std::size_t e : m_limits.pair(k)) ++m_first_pair[e];
    std::partial_sum(m_first_pair.begin(), m_first_pair.end(), m_first_pair.begin());
    m_pairs_of_edges.resize(2 * m_limits.number_of_pairs());
    for(std::size_t k = m_limits.number_of_pairs(); k-- > 0;)
      for(const std::size_t e : m_limits.pair(k))
        m_pairs_of_edges[--m_first_pair[e]] = static_cast<Index>(k);
    m_round_of_node.assign(m_start.size(), 0);
    m_round_of_pair.assign(m_limits.number_of_pairs(), 0);
  }

  const Limits& m_limits;
  Run_watch* m_watch; // none if null; it ends a search by Run_stopped
  const std::vector<Point_3> m_start;
  std::vector<Point_3> m_end;
  const Swept m_swept;
  std::vector<double> m_fractions;

  std::vector<std::size_t> m_first_pair; // in the next, of each edge
  Indices m_pairs_of_edges;
  Index m_round = 1;
  Indices m_round_of_node, m_round_of_pair; // in which each was tested last
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_SHORTENED_MOTION_H
