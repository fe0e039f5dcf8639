// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_PROJECTED_NODES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_PROJECTED_NODES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Strand_paths.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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
