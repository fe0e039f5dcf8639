// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_CROSSING_COUNTER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_CROSSING_COUNTER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Counts the crossings of a projected curve, in double arithmetic. Each edge is listed in the cells
// of a uniform grid that it runs through, cells as large as a mean edge; edges of one cell are
// tested pair by pair, and a crossing counts in the cell that it lies in. For curves with edges of
// similar length O(n + k) for k pairs in common cells; at 100,000 nodes 2 to 4 times faster than
// box_self_intersection_d, since edges are not boxes and all directions share the memory.
class Crossing_counter
{
public:
  using Index = std::uint32_t;

  template <typename Network>
  explicit Crossing_counter(const Network& curve) : m_edges(curve.number_of_edges())
  {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      m_edges[e].nodes = {static_cast<Index>(curve.source(e)), static_cast<Index>(curve.target(e))};
  }

  std::size_t operator()(const std::vector<Vector>& projection)
  {
    if(!lay_out_grid(projection)) return 0;
    list_edges();
    std::size_t crossings = 0;
    for(std::size_t cell = 0; cell + 1 < m_first.size(); ++cell)
      for(std::size_t i = m_first[cell]; i < m_first[cell + 1]; ++i)
        for(std::size_t j = m_first[cell]; j < i; ++j)
          if(do_cross_in(cell, m_edges[m_listed[i]], m_edges[m_listed[j]])) ++crossings;
    return crossings;
  }

private:
  using Point = Vector; // with z = 0

  static constexpr double margin = 1e-9; // in cells, for rounding

  struct Edge
  {
    Point source, target; // in cells
    std::array<Index, 2> nodes;
  };

  // returns false if all points coincide
  bool lay_out_grid(const std::vector<Point>& projection)
  {
    if(m_edges.empty()) return false;
    Point low = projection.front(), high = low;
    for(const Point& p : projection) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    double length = 0;
    for(const Edge& edge : m_edges)
      length += (projection[edge.nodes[1]] - projection[edge.nodes[0]]).norm();
    const double n = static_cast<double>(m_edges.size());
    const Point size = high - low;
    // not more than about 8 n cells
    const double cell_size = (std::max)(
        {length / n, std::sqrt(size.x() * size.y() / (4 * n)), size.maxCoeff() / (4 * n)});
    if(!(cell_size > 0)) return false;
    for(Edge& edge : m_edges) {
      edge.source = (projection[edge.nodes[0]] - low) / cell_size;
      edge.target = (projection[edge.nodes[1]] - low) / cell_size;
    }
    m_columns = 1 + static_cast<std::size_t>(size.x() / cell_size);
    m_rows = 1 + static_cast<std::size_t>(size.y() / cell_size);
    return true;
  }

  void list_edges()
  {
    m_first.assign(m_columns * m_rows + 1, 0);
    for(const Edge& edge : m_edges)
      for_each_cell(edge, [&](std::size_t cell) { ++m_first[cell + 1]; });
    for(std::size_t cell = 1; cell < m_first.size(); ++cell) m_first[cell] += m_first[cell - 1];
    m_listed.resize(m_first.back());
    m_end.assign(m_first.begin(), m_first.end());
    for(Index e = 0; e < m_edges.size(); ++e)
      for_each_cell(m_edges[e], [&](std::size_t cell) { m_listed[m_end[cell]++] = e; });
  }

  static std::size_t index(double x, std::size_t n)
  {
    return x > 0 ? (std::min)(static_cast<std::size_t>(x), n - 1) : 0;
  }

  template <typename Function>
  void for_each_cell(const Edge& edge, const Function& f) const
  {
    Point a = edge.source, b = edge.target;
    if(a.y() > b.y()) std::swap(a, b);
    const double height = b.y() - a.y();
    const std::size_t last = index(b.y() + margin, m_rows);
    for(std::size_t row = index(a.y() - margin, m_rows); row <= last; ++row) {
      const auto x_at = [&](double y) {
        const double t = height > 0 ? std::clamp((y - a.y()) / height, 0., 1.) : y > a.y();
        return a.x() + t * (b.x() - a.x());
      };
      const auto [left, right] = std::minmax(
          {x_at(static_cast<double>(row) - margin), x_at(static_cast<double>(row) + 1 + margin)});
      const std::size_t last_column = index(right + margin, m_columns);
      for(std::size_t column = index(left - margin, m_columns); column <= last_column; ++column)
        f(row * m_columns + column);
    }
  }

  static double turn(const Point& a, const Point& b, const Point& c)
  {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }

  bool do_cross_in(std::size_t cell, const Edge& e, const Edge& f) const
  {
    const double side_e = turn(f.source, f.target, e.source);
    const double other_side_e = turn(f.source, f.target, e.target);
    if((side_e > 0) == (other_side_e > 0)) return false;
    if((turn(e.source, e.target, f.source) > 0) == (turn(e.source, e.target, f.target) > 0))
      return false;
    if(std::count(f.nodes.begin(), f.nodes.end(), e.nodes[0]) > 0 ||
       std::count(f.nodes.begin(), f.nodes.end(), e.nodes[1]) > 0)
      return false;
    const Point p = e.source + side_e / (side_e - other_side_e) * (e.target - e.source);
    return index(p.y(), m_rows) * m_columns + index(p.x(), m_columns) == cell;
  }

  std::vector<Edge> m_edges;
  std::size_t m_columns = 0, m_rows = 0;
  std::vector<std::size_t> m_first, m_end; // per cell, into m_listed
  std::vector<Index> m_listed;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_CROSSING_COUNTER_H
