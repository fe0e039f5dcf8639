// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/measures/Curve_interval.h>
#include <CGAL/Volume_filling_curves/internal/measures/Least_pair_distance.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Least distance between two edges that are not neighbors. Neighbors share a node or are less than
// the mean of their neighborhoods apart along their component. Along a curve this is a difference
// of arc lengths; in a component with junctions it is the shortest path through the network, which
// Dijkstra's algorithm finds from every edge, up to its neighborhood; there it is enough if one of
// two edges finds the other. Near-linear time for curves (Least_pair_distance).
template <typename Network>
class Least_clearance
{
public:
  // Takes the neighborhood of each edge, 0 or more.
  Least_clearance(const Network& curve, std::vector<double> neighborhoods)
      : m_curve(curve),
        m_neighborhoods(std::move(neighborhoods)),
        m_unit(unit_of_size(curve)),
        m_spans(arc_length_spans(curve)),
        m_neighbors(curve.number_of_edges())
  {
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      if(m_neighborhoods[e] > 0 && m_spans.of_edge[e].component == Curve_interval::null)
        m_neighbors[e] = search(e);
  }

  Least_clearance(const Network& curve, double neighborhood)
      : Least_clearance(curve, std::vector<double>(curve.number_of_edges(), neighborhood))
  {}

  // returns the nearest two edges, null ones if all are neighbors
  Least_pair_distance::Pair nearest(Run_watch* watch = nullptr) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if(m_neighborhoods.empty()) return {infinity};
    const Least_pair_distance pairs(m_curve, m_spans, m_unit);
    const auto distance_of_others = [&](std::size_t e, std::size_t f) {
      return are_neighbors(e, f) ? infinity : distance(e, f);
    };
    const double least = *std::min_element(m_neighborhoods.begin(), m_neighborhoods.end());
    auto pair = pairs.nearest(infinity, least, distance_of_others, watch);
    pair.distance /= m_unit;
    return pair;
  }

  double operator()(Run_watch* watch = nullptr) const { return nearest(watch).distance; }

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
    return std::binary_search(m_neighbors[e].begin(), m_neighbors[e].end(), f);
  }

  double distance(std::size_t e, std::size_t f) const
  {
    const auto point = [&](std::size_t v) { return Vector(m_unit * to_vector(m_curve.point(v))); };
    return std::sqrt(squared_segment_distance(point(m_curve.source(e)), point(m_curve.target(e)),
                                              point(m_curve.source(f)), point(m_curve.target(f))));
  }

  // returns the edges at all nodes that are less than its neighborhood away from e, sorted
  std::vector<std::size_t> search(std::size_t e) const
  {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::map<std::size_t, double> reached;
    std::vector<std::size_t> edges;
    queue.push({0., m_curve.source(e)});
    queue.push({0., m_curve.target(e)});
    while(!queue.empty()) {
      const auto [path, v] = queue.top();
      queue.pop();
      if(!reached.insert({v, path}).second) continue;
      for(std::size_t k = 0; k < m_curve.degree(v); ++k) {
        const std::size_t f = m_curve.incident_edge(v, k);
        edges.push_back(f);
        const double next = path + edge_vector(m_curve, f).norm();
        if(next < m_neighborhoods[e]) queue.push({next, m_curve.neighbor(v, k)});
      }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  const Network& m_curve;
  const std::vector<double> m_neighborhoods;
  const double m_unit;
  const Curve_intervals m_spans;
  std::vector<std::vector<std::size_t>> m_neighbors; // at junctions only
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H
