// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CANONICAL_CURVE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CANONICAL_CURVE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>
#include <CGAL/Volume_filling_curves/internal/certificate/format.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Canonical form of a curve, independent of the numbering of its nodes and of its file, and the
// hash of this form: the nodes in lexicographic order of their coordinates, and the undirected
// edges in lexicographic order of their nodes' ranks. Nodes without an edge are left out: a
// certificate could move them anywhere. O(n log n).
class Canonical_curve
{
public:
  using Edge = std::array<std::uint64_t, 2>;

  // `Curve` has the functions nodes(), edges(), point(), source() and target() of a
  // Curve_network_3; nodes() may list them in any order.
  // \throws std::invalid_argument if a coordinate is not finite, or if an edge has a node that
  // nodes() does not list
  template <typename Curve>
  explicit Canonical_curve(const Curve& curve)
  {
    const std::vector<bool> has_edge = nodes_with_an_edge(curve);
    m_ranks.assign(has_edge.size(), unlisted);
    std::vector<Position> points;
    std::vector<std::size_t> nodes;
    for(const std::size_t v : curve.nodes()) {
      if(!has_edge[v]) continue;
      points.push_back(to_position(curve.point(v)));
      for(double& x : points.back()) {
        if(!std::isfinite(x))
          throw std::invalid_argument("node " + std::to_string(v) +
                                      " has a coordinate that is not finite");
        if(x == 0) x = 0; // -0 counts as 0
      }
      nodes.push_back(v);
    }
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return points[i] < points[j]; });
    for(const std::size_t i : order) {
      m_ranks[nodes[i]] = m_points.size();
      m_points.push_back(points[i]);
    }
    for(const std::size_t e : curve.edges()) add_edge(rank(curve.source(e)), rank(curve.target(e)));
    std::sort(m_edges.begin(), m_edges.end());
  }

  const std::vector<Position>& points() const { return m_points; }
  const std::vector<Edge>& edges() const { return m_edges; }

  // the index in points() of each node of the curve
  const std::vector<std::uint64_t>& ranks() const { return m_ranks; }

  std::uint64_t number_of_components() const
  {
    Disjoint_sets components(m_points.size());
    for(const Edge& edge : m_edges) components.unite(edge[0], edge[1]);
    return components.number_of_sets();
  }

  Sha256::Digest digest() const
  {
    std::string bytes;
    append_little_endian(bytes, std::uint64_t(m_points.size()));
    append_little_endian(bytes, std::uint64_t(m_edges.size()));
    for(const Position& p : m_points)
      for(const double x : p) append_little_endian(bytes, x);
    for(const Edge& edge : m_edges)
      for(const std::uint64_t v : edge) append_little_endian(bytes, v);
    return sha256(bytes);
  }

private:
  static constexpr std::uint64_t unlisted = (std::numeric_limits<std::uint64_t>::max)();

  // Flags of the nodes, up to the last one listed.
  template <typename Curve>
  static std::vector<bool> nodes_with_an_edge(const Curve& curve)
  {
    std::size_t end = 0;
    for(const std::size_t v : curve.nodes()) end = (std::max)(end, v + 1);
    std::vector<bool> has_edge(end, false);
    for(const std::size_t e : curve.edges())
      for(const std::size_t v : {curve.source(e), curve.target(e)})
        if(v < end) has_edge[v] = true;
    return has_edge;
  }

  std::uint64_t rank(std::size_t v) const
  {
    if(v >= m_ranks.size() || m_ranks[v] == unlisted)
      throw std::invalid_argument("an edge has node " + std::to_string(v) +
                                  ", which is not among the nodes of the curve");
    return m_ranks[v];
  }

  void add_edge(std::uint64_t v, std::uint64_t w)
  {
    m_edges.push_back({(std::min)(v, w), (std::max)(v, w)});
  }

  std::vector<Position> m_points;
  std::vector<Edge> m_edges;
  std::vector<std::uint64_t> m_ranks;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CANONICAL_CURVE_H
