// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_AVERAGE_CROSSING_NUMBER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_AVERAGE_CROSSING_NUMBER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Counter of the crossings of a projected curve, in double arithmetic. A uniform grid with cells
// about as large as a mean edge lists the edges through each cell. Edges of one cell are tested
// pair by pair, and a crossing counts in its own cell. O(n + k) for edges of similar length and k
// pairs in common cells; at 100,000 nodes several times faster than box_self_intersection_d, since
// edges fill few cells of their boxes and all directions share the memory.
class Crossing_counter
{
public:
  using Index = std::uint32_t;

  template <typename Network>
  explicit Crossing_counter(const Network& curve)
      : m_edges(curve.number_of_edges()), m_positions(curve.number_of_nodes())
  {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      m_edges[e].nodes = {static_cast<Index>(curve.source(e)), static_cast<Index>(curve.target(e))};
  }

  // \throws Run_stopped if a watch requests it
  std::size_t operator()(const std::vector<Vector>& projection, Run_watch* watch = nullptr)
  {
    check(watch);
    if(!lay_out_grid(projection)) return 0;
    list_edges();
    std::size_t crossings = 0;
    unsigned visits = 0;
    for(std::size_t cell = 0; cell + 1 < m_first.size(); ++cell) {
      check_sometimes(watch, visits);
      for(std::size_t i = m_first[cell]; i < m_first[cell + 1]; ++i)
        for(std::size_t j = m_first[cell]; j < i; ++j)
          if(do_cross_in(cell, m_edges[m_listed[i]], m_edges[m_listed[j]])) ++crossings;
    }
    return crossings;
  }

private:
  struct Point
  {
    double x, y;
  };

  using Cell = std::ptrdiff_t; // to which a double is converted faster than to std::size_t

  // in mean lengths of an edge; with 0.7 as with 2 a tangle of 64,000 edges takes a tenth longer
  static constexpr double size_of_cell = 1.4;
  static constexpr double margin = 1e-9; // in cells, for rounding

  struct Edge
  {
    Point source, target; // in cells
    std::array<Index, 2> nodes;
  };

  // returns false if all points coincide
  bool lay_out_grid(const std::vector<Vector>& projection)
  {
    if(m_edges.empty()) return false;
    Vector low = projection.front(), high = low;
    for(const Vector& p : projection) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    double length = 0;
    for(const Edge& edge : m_edges)
      length += (projection[edge.nodes[1]] - projection[edge.nodes[0]]).norm();
    const double n = static_cast<double>(m_edges.size());
    const Vector size = high - low;
    // not more than about 8 n cells
    const double cell_size =
        (std::max)({size_of_cell * length / n, std::sqrt(size.x() * size.y() / (4 * n)),
                    size.maxCoeff() / (4 * n)});
    if(!(cell_size > 0)) return false;
    for(std::size_t v = 0; v < projection.size(); ++v) {
      const Vector x = projection[v] - low;
      m_positions[v] = {x.x() / cell_size, x.y() / cell_size};
    }
    for(Edge& edge : m_edges) {
      edge.source = m_positions[edge.nodes[0]];
      edge.target = m_positions[edge.nodes[1]];
    }
    m_columns = 1 + static_cast<Cell>(size.x() / cell_size);
    m_rows = 1 + static_cast<Cell>(size.y() / cell_size);
    return true;
  }

  // Sorts the edges by cells, in which they keep their order.
  void list_edges()
  {
    m_first.assign(static_cast<std::size_t>(m_columns * m_rows) + 1, 0);
    m_entries.clear();
    for(Index e = 0; e < m_edges.size(); ++e)
      for_each_cell(m_edges[e], [&](std::size_t cell) {
        ++m_first[cell + 1];
        m_entries.push_back({cell, e});
      });
    for(std::size_t cell = 1; cell < m_first.size(); ++cell) m_first[cell] += m_first[cell - 1];
    m_listed.resize(m_entries.size());
    m_end.assign(m_first.begin(), m_first.end());
    for(const auto& [cell, e] : m_entries) m_listed[m_end[cell]++] = e;
  }

  static Cell index(double x, Cell n)
  {
    return x > 0 ? (std::min)(static_cast<Cell>(x), n - 1) : 0;
  }

  template <typename Function>
  void for_each_cell(const Edge& edge, const Function& f) const
  {
    const auto [low, high] = std::minmax(edge.source, edge.target,
                                         [](const Point& p, const Point& q) { return p.y < q.y; });
    const Cell first = index(low.y - margin, m_rows), last = index(high.y + margin, m_rows);
    const auto [left, right] = std::minmax(low.x, high.x);
    const double height = high.y - low.y;
    const bool is_steep = first < last && height > margin; // else it takes all columns of a row
    const double slope = is_steep ? (high.x - low.x) / height : 0;
    for(Cell row = first; row <= last; ++row) {
      const double y = static_cast<double>(row) - low.y;
      const auto [x, next_x] =
          std::minmax({low.x + slope * (y - margin), low.x + slope * (y + 1 + margin)});
      const double from = is_steep ? (std::max)(x, left) : left;
      const double to = is_steep ? (std::min)(next_x, right) : right;
      const Cell last_column = index(to + margin, m_columns);
      for(Cell column = index(from - margin, m_columns); column <= last_column; ++column)
        f(static_cast<std::size_t>(row * m_columns + column));
    }
  }

  static double turn(const Point& a, const Point& b, const Point& c)
  {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
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
    const double t = side_e / (side_e - other_side_e);
    const double x = e.source.x + t * (e.target.x - e.source.x);
    const double y = e.source.y + t * (e.target.y - e.source.y);
    return static_cast<std::size_t>(index(y, m_rows) * m_columns + index(x, m_columns)) == cell;
  }

  std::vector<Edge> m_edges;
  std::vector<Point> m_positions; // of the nodes, in cells
  Cell m_columns = 0, m_rows = 0;
  std::vector<std::size_t> m_first, m_end; // per cell, into m_listed
  std::vector<std::pair<std::size_t, Index>> m_entries;
  std::vector<Index> m_listed;
};

// Mean number of crossings over 100 directions, evenly distributed over the half-sphere: a
// Fibonacci lattice (each direction a golden angle further around the axis), rotated to avoid
// special directions of curves on a lattice. Fixed directions make the number reproducible; its
// sampling error is about 1 %.

constexpr std::size_t number_of_viewing_directions = 100;

// returns a rotation whose third row is the k-th direction
inline Frame viewing_frame(std::size_t k)
{
  constexpr double golden_angle = 0.38196601125010515; // in turns
  const double index = static_cast<double>(k);
  const double z = (index + 0.5) / static_cast<double>(number_of_viewing_directions);
  const double radius = std::sqrt(1 - z * z);
  const auto [x, y] = cos_sin(golden_angle * index);
  const Vector front = generic_frame()(Vector(radius * x, radius * y, z));
  const Vector right = front.unitOrthogonal();
  return {right, front.cross(right), front};
}

// Returns the mean over every `stride`-th direction. The unit keeps products of lengths from
// underflowing; the grid would have one cell for all edges.
template <typename ConcurrencyTag = Sequential_tag, typename Network>
double average_crossing_number(const Network& curve,
                               std::size_t stride = 1,
                               Run_watch* watch = nullptr)
{
  constexpr std::size_t block = 10; // directions that share the memory of a counter
  const Vector_field points = unit_of_size(curve) * coordinates(curve);
  std::vector<std::size_t> crossings((number_of_viewing_directions + stride - 1) / stride);
  for_each_block<ConcurrencyTag>(crossings.size(), block, [&](std::size_t begin, std::size_t end) {
    std::vector<Vector> projection(curve.number_of_nodes());
    Crossing_counter count(curve);
    for(std::size_t k = begin; k < end; ++k) {
      const Frame frame = viewing_frame(k * stride);
      for(std::size_t v = 0; v < projection.size(); ++v) {
        const Vector x = row(points, v);
        projection[v] = {frame.first.dot(x), frame.second.dot(x), 0};
      }
      crossings[k] = count(projection, watch);
    }
  });
  return static_cast<double>(std::accumulate(crossings.begin(), crossings.end(), std::size_t(0))) /
         static_cast<double>(crossings.size());
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_AVERAGE_CROSSING_NUMBER_H
