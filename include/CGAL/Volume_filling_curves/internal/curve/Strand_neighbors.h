// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_STRAND_NEIGHBORS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_STRAND_NEIGHBORS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_interval.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// returns the edges at all nodes within a distance less than `reach` along the network, sorted.
// Distances start with given values at some nodes, and paths avoid edges for which
// is_taken_out(edge). (Dijkstra)
template <typename Network, typename IsTakenOut>
std::vector<std::size_t> edges_within(const Network& curve,
                                      const std::vector<std::pair<double, std::size_t>>& starts,
                                      double reach,
                                      const IsTakenOut& is_taken_out)
{
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::map<std::size_t, double> reached;
  std::vector<std::size_t> edges;
  for(const Entry& start : starts)
    if(start.first < reach) queue.push(start);
  while(!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if(!reached.insert({v, distance}).second) continue;
    for(std::size_t k = 0; k < curve.degree(v); ++k) {
      const std::size_t f = curve.incident_edge(v, k);
      if(is_taken_out(f)) continue;
      edges.push_back(f);
      const double next = distance + edge_vector(curve, f).norm();
      if(next < reach) queue.push({next, curve.neighbor(v, k)});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Neighborhood of edges of one strand: neighbors share a node, or their distance along the
// component is less than the mean of their neighborhoods. Along a curve, this distance is a
// difference of arc lengths; in a component with junctions, it is that of a shortest path, and it
// suffices if one of two edges finds the other. Linear to build for curves, constant time per pair.
template <typename Network>
class Strand_neighbors
{
public:
  // Takes the neighborhood of each edge, 0 or more.
  Strand_neighbors(const Network& curve, std::vector<double> neighborhoods)
      : m_curve(curve),
        m_neighborhoods(std::move(neighborhoods)),
        m_spans(arc_length_spans(curve)),
        m_found(curve.number_of_edges())
  {
    const auto none = [](std::size_t) { return false; };
    for(std::size_t e = 0; e < m_found.size(); ++e)
      if(m_neighborhoods[e] > 0 && m_spans.of_edge[e].component == Curve_interval::null)
        m_found[e] = edges_within(curve, {{0., curve.source(e)}, {0., curve.target(e)}},
                                  m_neighborhoods[e], none);
  }

  const Curve_intervals& spans() const { return m_spans; }
  const std::vector<double>& neighborhoods() const { return m_neighborhoods; }

  bool are_neighbors(std::size_t e, std::size_t f) const
  {
    if(share_a_node(m_curve, e, f)) return true;
    if(m_spans.of_edge[e].is_comparable(m_spans.of_edge[f]))
      return m_spans.gap(e, f) < (m_neighborhoods[e] + m_neighborhoods[f]) / 2;
    return finds(e, f) || finds(f, e);
  }

private:
  bool finds(std::size_t e, std::size_t f) const
  {
    return std::binary_search(m_found[e].begin(), m_found[e].end(), f);
  }

  const Network& m_curve;
  std::vector<double> m_neighborhoods;
  Curve_intervals m_spans;
  std::vector<std::vector<std::size_t>> m_found; // in components with junctions only
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_STRAND_NEIGHBORS_H
