// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CURVE_SIMPLIFIER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CURVE_SIMPLIFIER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Replaced_chains.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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
      : m_guard(guard), m_curve(guard.curve()), m_chains(m_curve), m_max_distance(max_distance)
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

  Vector position(std::size_t v) const { return to_vector(m_curve.point(v)); }

  Guard& m_guard;
  const Network& m_curve;
  Replaced_chains<Network> m_chains;
  double m_max_distance;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> m_candidates;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CURVE_SIMPLIFIER_H
