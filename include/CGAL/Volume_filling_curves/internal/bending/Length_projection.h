// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_LENGTH_PROJECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_LENGTH_PROJECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Projected_nodes.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Projection of the edges of a path towards lengths: a tense path keeps its own, otherwise edges
// are evened.
class Length_projection
{
  using Path = Projected_nodes::Path;
  using Range = Projected_nodes::Range;

public:
  // Nodes and path must outlive the projection.
  Length_projection(const Projected_nodes& nodes,
                    const Shape_limits& limits,
                    const Path& path,
                    bool is_tense)
      : m_nodes(nodes), m_path(path), m_is_tense(is_tense)
  {
    if(is_tense) {
      m_lengths = lengths_to_keep(limits);
      m_ranges = nodes.moving_ranges(path, path.begin + path.number_of_edges(), 1);
    } else {
      m_ranges = nodes.moving_ranges(path, path.end, 0);
    }
  }

  void operator()(std::vector<Vector>& x) const
  {
    for(const auto& [begin, end] : m_ranges)
      for(std::size_t i = begin; i < end; ++i)
        if(m_is_tense)
          keep_length(x, i);
        else
          even(x, i);
  }

private:
  // Lengths of the edges to be kept: their sum is that at the start, except next to held nodes.
  // Arcs get even edges: short ones behind the necks of ports would stay short, and six of 56
  // fillings between ports would not converge, instead of one (2026-11-27).
  std::vector<double> lengths_to_keep(const Shape_limits& limits) const
  {
    std::vector<double> lengths;
    for(std::size_t i = m_path.begin; i < m_path.begin + m_path.number_of_edges(); ++i)
      lengths.push_back((m_nodes.start(node(i + 1)) - m_nodes.start(node(i))).norm());
    return m_path.is_closed ? averaged(lengths) : evened(limits, lengths);
  }

  // Averages over seven successive edges of a closed path. With even edges instead, eight domains
  // are filled to 0.5 % less in 1.1 times the time: bends within their limits give way.
  static std::vector<double> averaged(const std::vector<double>& lengths)
  {
    const std::size_t n = lengths.size(), reach = (std::min)(n, std::size_t(3));
    std::vector<double> averages(n, 0);
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t k = i + n - reach; k <= i + n + reach; ++k)
        averages[i] += lengths[k % n] / static_cast<double>(2 * reach + 1);
    return averages;
  }

  // Edges are as long as the thickness asks for, where that varies. With the same length for all,
  // the curve contracted: in a cube whose thickness grows from 0.15 to 0.6 to half of its length.
  // The mean is that of edges which are not held: those in the necks of ports stay as they are, and
  // being shorter they would make all others shrink in each sweep.
  std::vector<double> evened(const Shape_limits& limits, const std::vector<double>& lengths) const
  {
    const auto limit = [&](std::size_t v) {
      return limits.bend_radius[v] + limits.strand_distance[v];
    };
    std::vector<double> even;
    double sum = 0, sum_of_limits = 0;
    for(std::size_t i = 0; i < lengths.size(); ++i) {
      const std::size_t v = node(m_path.begin + i), w = node(m_path.begin + i + 1);
      even.push_back((std::max)(limit(v), limit(w))); // a ray has none
      if(m_nodes.are_held({v, w})) continue;
      sum += lengths[i];
      sum_of_limits += even.back();
    }
    for(double& length : even) length *= sum_of_limits > 0 ? sum / sum_of_limits : 0;
    return even;
  }

  // Moves the ends of an edge towards its length; i is the index of the first one in all paths.
  void keep_length(std::vector<Vector>& x, std::size_t i) const
  {
    const std::size_t v = node(i), w = node(i + 1);
    const Vector edge = x[w] - x[v];
    const double now = edge.norm();
    if(!(now > 0)) return;
    const Vector half = (now - m_lengths[i - m_path.begin]) / (2 * now) * edge;
    m_nodes.move(x, v, half);
    m_nodes.move(x, w, -half);
  }

  // Slides the i-th node of all paths towards the longer one of its edges, since corners between
  // uneven edges bend sharply (Rawdon's MinRad). Folds have no direction to slide in.
  void even(std::vector<Vector>& x, std::size_t i) const
  {
    constexpr double rate = 0.2; // half would even two edges, but the other nodes slide as well
    constexpr double fold = 0.5; // the length of the tangent where the curve turns by 151 degrees
    if(!m_path.is_closed && (i == m_path.begin || i + 1 == m_path.end)) return;
    const std::size_t v = node(i), w = node(i + 1);
    const std::size_t u = node(i > m_path.begin ? i - 1 : m_path.end - 1);
    const Vector in = x[v] - x[u], out = x[w] - x[v];
    const double length_in = in.norm(), length_out = out.norm();
    if(!(length_in > 0 && length_out > 0)) return;
    const Vector tangent = in / length_in + out / length_out;
    const double norm = tangent.norm();
    if(norm > fold) m_nodes.move(x, v, rate * (length_out - length_in) / norm * tangent);
  }

  std::size_t node(std::size_t i) const { return m_nodes.node(m_path, i); }

  const Projected_nodes& m_nodes;
  const Path& m_path;
  const bool m_is_tense;
  std::vector<double> m_lengths; // to be kept, of each edge of a tense path
  std::vector<Range> m_ranges;   // of edges, or of nodes, that can move
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_LENGTH_PROJECTION_H
