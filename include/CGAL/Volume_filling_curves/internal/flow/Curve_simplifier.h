// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CURVE_SIMPLIFIER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CURVE_SIMPLIFIER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Chains of former nodes that the edges of a curve replace while nodes are removed, and tests
// whether an edge is within a given Frechet distance of a chain: whether points of the edge, in
// order, can be assigned to the nodes of the chain, none farther than this. (Between nodes, the
// linear assignment is no farther, since distance is convex; Alt and Godau 1995.) Linear in the
// number of nodes of the chain.
template <typename Network>
class Replaced_chains
{
  using Index = std::uint32_t;

public:
  // Takes the factor from coordinates to lengths of the tests.
  Replaced_chains(const Network& curve, double factor)
      : m_curve(curve), m_points(curve.number_of_nodes()), m_neighbors(curve.number_of_nodes())
  {
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
      m_points[v] = factor * to_vector(curve.point(v));
      for(std::size_t k = 0; k < 2 && curve.degree(v) == 2; ++k)
        m_neighbors[v][k] = static_cast<Index>(curve.neighbor(v, k));
    }
    m_first.resize(curve.number_of_edges());
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      m_first[e] = {static_cast<Index>(curve.target(e)), static_cast<Index>(curve.source(e))};
  }

  // returns whether the edge that would join the neighbors of node v is within the distance of the
  // chain between them
  bool is_shortcut_near(std::size_t v, double distance) const
  {
    const std::size_t a = m_curve.neighbor(v, 0), c = m_curve.neighbor(v, 1);
    const Vector &start = m_points[a], to_end = m_points[c] - start;
    double reached = 0;
    const auto advance = [&](std::size_t w) {
      return move_on(m_points[w] - start, to_end, distance, reached);
    };
    return holds_inside(m_curve.incident_edge(v, 0), a, v, advance) && advance(v) &&
           holds_inside(m_curve.incident_edge(v, 1), v, c, advance);
  }

  // Two edges that become one: their far ends, and the nodes of the chain next to these.
  struct Union
  {
    std::array<std::size_t, 2> edges, ends;
    std::array<Index, 2> first;
  };

  // returns the union of the two edges at node v, to be passed to `join()` once v has been removed
  Union edges_at(std::size_t v) const
  {
    Union both;
    for(std::size_t k = 0; k < 2; ++k) {
      both.edges[k] = m_curve.incident_edge(v, k);
      both.ends[k] = m_curve.neighbor(v, k);
      both.first[k] = first_node(both.edges[k], both.ends[k]);
    }
    return both;
  }

  // Records that the two edges have become one.
  void join(const Union& both)
  {
    const std::size_t e = both.edges[m_curve.is_removed_edge(both.edges[0]) ? 1 : 0];
    m_first[e] = both.first;
    if(m_curve.source(e) != both.ends[0]) std::swap(m_first[e][0], m_first[e][1]);
  }

private:
  Index first_node(std::size_t e, std::size_t end) const
  {
    return m_first[e][m_curve.source(e) == end ? 0 : 1];
  }

  // Calls f for the nodes inside the chain of edge e, from one end to the other, until it returns
  // false. Returns whether it never did.
  template <typename Function>
  bool holds_inside(std::size_t e, std::size_t from, std::size_t to, const Function& f) const
  {
    std::size_t last = from, v = first_node(e, from);
    while(v != to) {
      if(!f(v)) return false;
      const std::size_t next = m_neighbors[v][m_neighbors[v][0] == last ? 1 : 0];
      last = v;
      v = next;
    }
    return true;
  }

  // Moves on along the segment from 0 to `end` to the first point within the distance of p, and
  // returns whether there is one that is not before the point reached so far.
  static bool move_on(const Vector& p, const Vector& end, double distance, double& reached)
  {
    const double length = end.norm();
    const Vector direction = end / length;
    const double along = p.dot(direction);
    const double rest = distance * distance - (p - along * direction).squaredNorm();
    if(!(rest >= 0)) return false;
    reached = (std::max)(reached, along - std::sqrt(rest));
    return reached <= (std::min)(length, along + std::sqrt(rest));
  }

  const Network& m_curve;
  std::vector<Vector> m_points;
  std::vector<std::array<Index, 2>> m_neighbors; // of former nodes with two
  std::vector<std::array<Index, 2>> m_first;     // per edge, next to its source and its target
};

// Simplifier, which removes nodes in order of their effect on the curve, least first, until the
// guard or the distance to the former curve allows no further removal. Refused removals are tried
// again after the others, since the obstacle may be gone by then; a round without any removal is
// the last. Near-linear per round in practice, with a few rounds.
template <typename Guard>
class Curve_simplifier
{
  using Network = typename Guard::Curve_network;

public:
  Curve_simplifier(Guard& guard, double max_distance)
      : m_guard(guard),
        m_curve(guard.curve()),
        m_factor(unit_factor(m_curve)),
        m_chains(m_curve, m_factor),
        m_max_distance(m_factor * max_distance)
  {}

  // Returns the number of nodes that were removed, which leave garbage in the network. Ends early
  // if a watch requests it.
  std::size_t run(Run_watch* watch = nullptr)
  {
    std::size_t count = 0;
    for(std::size_t last = run_round(watch); last > 0; last = run_round(watch)) count += last;
    return count;
  }

private:
  // the change, the node, and the neighbors for which the change was measured
  using Candidate = std::tuple<double, std::size_t, std::size_t, std::size_t>;

  std::size_t run_round(Run_watch* watch)
  {
    std::size_t count = 0;
    for(const std::size_t v : m_curve.nodes()) add_candidate(v);
    while(!m_candidates.empty() && !(watch != nullptr && watch->must_stop())) {
      const auto [change, v, a, c] = m_candidates.top();
      m_candidates.pop();
      if(!m_curve.is_removable(v) || m_curve.neighbor(v, 0) != a || m_curve.neighbor(v, 1) != c)
        continue;
      if(!remove(v)) continue;
      ++count;
      add_candidate(a);
      add_candidate(c);
    }
    return count;
  }

  void add_candidate(std::size_t v)
  {
    if(!m_curve.is_removable(v)) return;
    const std::size_t a = m_curve.neighbor(v, 0), c = m_curve.neighbor(v, 1);
    const double change = squared_distance_to_segment(position(v), position(a), position(c));
    if(change <= m_max_distance * m_max_distance) m_candidates.emplace(change, v, a, c);
  }

  bool remove(std::size_t v)
  {
    if(m_max_distance < std::numeric_limits<double>::infinity() &&
       !m_chains.is_shortcut_near(v, m_max_distance))
      return false;
    const auto edges = m_chains.edges_at(v);
    if(!m_guard.remove_node(v)) return false;
    m_chains.join(edges);
    return true;
  }

  // Returns the power of two that makes the largest coordinate about 1, so that no squares of
  // distances underflow.
  static double unit_factor(const Network& curve)
  {
    double largest = 0;
    for(const std::size_t v : curve.nodes())
      largest = (std::max)(largest, to_vector(curve.point(v)).cwiseAbs().maxCoeff());
    return largest > 0 ? scale_to_one(largest) : 1;
  }

  Vector position(std::size_t v) const { return m_factor * to_vector(m_curve.point(v)); }

  Guard& m_guard;
  const Network& m_curve;
  const double m_factor;
  Replaced_chains<Network> m_chains;
  const double m_max_distance;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> m_candidates;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CURVE_SIMPLIFIER_H
