// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PATHS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PATHS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Paths of a network from one end or junction to the next, and its closed curves, as sequences of
// nodes that are consecutive in memory. Linear.
class Strand_paths
{
public:
  using Index = std::uint32_t;

  struct Path
  {
    std::size_t begin, end; // of its nodes; a closed path does not repeat its first node
    bool is_closed;

    std::size_t size() const { return end - begin; }
    std::size_t number_of_edges() const { return is_closed ? size() : size() - 1; }
  };

  // \pre there is no garbage
  template <typename Network>
  explicit Strand_paths(const Network& curve) : m_is_done(curve.number_of_edges(), false)
  {
    m_nodes.reserve(curve.number_of_nodes());
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      if(curve.degree(v) != 2) walk_from(curve, v);
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      if(curve.degree(v) == 2) walk_from(curve, v); // only closed curves are left
    m_is_done = {};
  }

  const std::vector<Path>& paths() const { return m_paths; }
  const std::vector<Index>& nodes() const { return m_nodes; }

private:
  template <typename Network>
  void walk_from(const Network& curve, std::size_t start)
  {
    for(std::size_t k = 0; k < curve.degree(start); ++k)
      if(!m_is_done[curve.incident_edge(start, k)]) walk(curve, start, k);
  }

  // along the k-th edge at a node
  template <typename Network>
  void walk(const Network& curve, std::size_t start, std::size_t k)
  {
    const std::size_t begin = m_nodes.size();
    std::size_t v = start, e = curve.incident_edge(v, k);
    do {
      m_nodes.push_back(static_cast<Index>(v));
      m_is_done[e] = true;
      v = curve.neighbor(v, k);
      if(curve.degree(v) != 2) break;
      k = curve.incident_edge(v, 0) == e ? 1 : 0;
      e = curve.incident_edge(v, k);
    } while(v != start);
    const bool is_closed = v == start && curve.degree(v) == 2;
    if(!is_closed) m_nodes.push_back(static_cast<Index>(v));
    m_paths.push_back({begin, m_nodes.size(), is_closed});
  }

  std::vector<Path> m_paths;
  std::vector<Index> m_nodes;
  std::vector<char> m_is_done; // of the edges
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PATHS_H
