// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_PROJECTED_NODES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_PROJECTED_NODES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
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
  explicit Strand_paths(const Network& curve)
  {
    std::vector<char> is_done(curve.number_of_edges(), false);
    m_nodes.reserve(curve.number_of_nodes());
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      if(curve.degree(v) != 2) walk_from(curve, v, is_done);
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      if(curve.degree(v) == 2) walk_from(curve, v, is_done); // only closed curves are left
  }

  const std::vector<Path>& paths() const { return m_paths; }
  const std::vector<Index>& nodes() const { return m_nodes; }

private:
  template <typename Network>
  void walk_from(const Network& curve, std::size_t start, std::vector<char>& is_done)
  {
    for(std::size_t k = 0; k < curve.degree(start); ++k)
      if(!is_done[curve.incident_edge(start, k)]) walk(curve, start, k, is_done);
  }

  // Walks along the k-th edge at a node, and marks the edges.
  template <typename Network>
  void walk(const Network& curve, std::size_t start, std::size_t k, std::vector<char>& is_done)
  {
    const std::size_t begin = m_nodes.size();
    std::size_t v = start, e = curve.incident_edge(v, k);
    do {
      m_nodes.push_back(static_cast<Index>(v));
      is_done[e] = true;
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
};

// Nodes that a projection moves along the paths of a curve. Some are held, and loops over a path
// leave out the stretches in which all are.
class Projected_nodes
{
public:
  using Path = Strand_paths::Path;
  using Index = Strand_paths::Index;
  using Range = std::array<std::size_t, 2>;

  // Holds the nodes that are not free.
  template <typename Network>
  explicit Projected_nodes(const Network& curve) : m_paths(curve)
  {
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      m_mobility.push_back(curve.is_free(v) ? 1 : 0);
    for(const auto& p : curve.points()) m_start.push_back(to_vector(p));
  }

  // Holds the other nodes, too.
  void move_only(const std::vector<bool>& moving)
  {
    for(std::size_t v = 0; v < m_mobility.size(); ++v)
      if(!moving[v]) m_mobility[v] = 0;
  }

  const std::vector<Path>& paths() const { return m_paths.paths(); }

  // the nodes of all paths, one path after another
  const Index* nodes() const { return m_paths.nodes().data(); }

  // the i-th node of all paths, also beyond the end of a closed one
  std::size_t node(const Path& path, std::size_t i) const
  {
    return nodes()[i < path.end ? i : i - path.size()];
  }

  // the position of a node before the projection
  const Vector& start(std::size_t v) const { return m_start[v]; }

  // 1, or 0 for a node that is held
  const std::vector<double>& mobility() const { return m_mobility; }
  bool is_held(std::size_t v) const { return m_mobility[v] == 0; }

  bool are_held(std::initializer_list<std::size_t> nodes) const
  {
    for(const std::size_t v : nodes)
      if(!is_held(v)) return false;
    return true;
  }

  void move(std::vector<Vector>& x, std::size_t v, const Vector& shift) const
  {
    x[v] += m_mobility[v] * shift;
  }

  // Returns the maximal ranges of the indices i, from the begin of a path to an end, for which any
  // of the nodes i to i + reach can move, around the end of a closed path. \pre reach is less than
  // the number of nodes
  std::vector<Range> moving_ranges(const Path& path, std::size_t end, std::size_t reach) const
  {
    std::vector<Range> ranges;
    std::size_t last = path.begin; // end of the last range
    for(std::size_t i = path.begin; i < path.end + (path.is_closed ? reach : 0); ++i) {
      if(is_held(node(path, i))) continue;
      const std::size_t first = (std::max)(last, i < path.begin + reach ? path.begin : i - reach);
      last = (std::min)(i + 1, end);
      if(first >= last) continue;
      if(!ranges.empty() && ranges.back()[1] >= first)
        ranges.back()[1] = last;
      else
        ranges.push_back({first, last});
    }
    return ranges;
  }

private:
  const Strand_paths m_paths;
  std::vector<Vector> m_start;
  std::vector<double> m_mobility;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_PROJECTED_NODES_H
