// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_GRAPH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_GRAPH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Points and edges of polylines in memory. Points are numbered in the order of the polylines. A
// last point that closes a polyline is not a new point, and neither is, if junctions are allowed,
// an end at the position of an earlier end. A point that repeats its predecessor keeps its number
// but gets no edge. O(n + k log k) for k polylines with n points.
class Polyline_graph
{
public:
  Polyline_graph(Closure closure, Junctions junctions)
      : m_closure(closure), m_has_common_ends(junctions == Junctions::ALLOWED)
  {}

  // Adds one polyline, or those of a range; nothing if the range is empty.
  // \throws std::invalid_argument if one has too few distinct points, or a point is not
  // finite or beyond 1e150
  template <typename PolylineRange, typename PointMap>
  void add(const PolylineRange& polylines, const PointMap& point_map)
  {
    if constexpr(is_range_of_ranges<PolylineRange>) {
      for(const auto& polyline : polylines) add_polyline(polyline, point_map);
    } else {
      if(std::begin(polylines) != std::end(polylines)) add_polyline(polylines, point_map);
    }
  }

  const std::vector<Vector>& points() const { return m_points; }

  const std::vector<std::array<std::size_t, 2>>& edges() const { return m_edges; }

private:
  template <typename PointRange, typename PointMap>
  void add_polyline(const PointRange& polyline, const PointMap& point_map)
  {
    m_polyline.clear();
    for(const auto& item : polyline) m_polyline.push_back(to_vector(get(point_map, item)));
    check_coordinates();
    const bool is_closed = drop_repeated_end();
    const std::vector<std::size_t> distinct = distinct_points(is_closed);
    if(distinct.size() < (is_closed ? 3 : 2))
      fail(is_closed ? "is closed and has fewer than three distinct points"
                     : "has fewer than two distinct points");
    m_numbers.clear();
    for(std::size_t i = 0; i < m_polyline.size(); ++i) {
      const bool is_end = i == distinct.front() || (!is_closed && i == distinct.back());
      m_numbers.push_back(is_end ? add_end(m_polyline[i]) : add_point(m_polyline[i]));
    }
    for(std::size_t k = 1; k < distinct.size(); ++k)
      m_edges.push_back({m_numbers[distinct[k - 1]], m_numbers[distinct[k]]});
    if(is_closed) m_edges.push_back({m_numbers[distinct.back()], m_numbers[distinct.front()]});
    ++m_number_of_polylines;
  }

  void check_coordinates() const
  {
    for(std::size_t i = 0; i < m_polyline.size(); ++i)
      check_range(m_polyline[i], "point " + std::to_string(i) + " of " + name());
  }

  // Returns whether the polyline is closed.
  bool drop_repeated_end()
  {
    if(m_closure == Closure::OPEN) return false;
    const bool is_repeated = m_polyline.size() > 1 && m_polyline.front() == m_polyline.back();
    if(is_repeated) m_polyline.pop_back();
    return is_repeated || m_closure == Closure::CLOSED;
  }

  // Returns the indices of the points that differ from their predecessors.
  std::vector<std::size_t> distinct_points(bool is_closed) const
  {
    std::vector<std::size_t> indices;
    for(std::size_t i = 0; i < m_polyline.size(); ++i)
      if(indices.empty() || m_polyline[i] != m_polyline[i - 1]) indices.push_back(i);
    while(is_closed && indices.size() > 1 && m_polyline[indices.back()] == m_polyline.front())
      indices.pop_back();
    return indices;
  }

  std::size_t add_point(const Vector& point)
  {
    m_points.push_back(point);
    return m_points.size() - 1;
  }

  std::size_t add_end(const Vector& point)
  {
    if(!m_has_common_ends) return add_point(point);
    const auto [end, is_new] =
        m_ends.emplace(std::array<double, 3>{point.x(), point.y(), point.z()}, m_points.size());
    return is_new ? add_point(point) : end->second;
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::invalid_argument(name() + " " + what);
  }

  std::string name() const { return "polyline " + std::to_string(m_number_of_polylines); }

  Closure m_closure;
  bool m_has_common_ends;
  std::size_t m_number_of_polylines = 0;
  std::vector<Vector> m_polyline;     // that is being added
  std::vector<std::size_t> m_numbers; // of its points
  std::map<std::array<double, 3>, std::size_t> m_ends;
  std::vector<Vector> m_points;
  std::vector<std::array<std::size_t, 2>> m_edges;
};

// The graph of the polylines that named parameters describe.
template <typename PolylineRange, typename NamedParameters>
Polyline_graph graph_of_polylines(const PolylineRange& polylines, const NamedParameters& np)
{
  Polyline_graph graph(closure_of(np), junctions_of(np));
  graph.add(polylines, point_map_of<PolylineRange>(np));
  return graph;
}

// Conversion of vectors and rows of matrices to points and edges of a network.

template <typename Traits>
std::vector<typename Traits::Point_3> to_points(const std::vector<Vector>& vectors,
                                                const Traits& traits)
{
  std::vector<typename Traits::Point_3> points;
  points.reserve(vectors.size());
  for(const Vector& v : vectors) points.push_back(to_point(v, traits));
  return points;
}

template <typename Matrix, typename Traits>
std::vector<typename Traits::Point_3> rows_to_points(const Eigen::MatrixBase<Matrix>& matrix,
                                                     const Traits& traits)
{
  CGAL_precondition_msg(matrix.cols() == 3, "`points` has three columns");
  std::vector<Vector> vectors;
  vectors.reserve(static_cast<std::size_t>(matrix.rows()));
  for(Eigen::Index i = 0; i < matrix.rows(); ++i) {
    vectors.emplace_back(matrix(i, 0), matrix(i, 1), matrix(i, 2));
    if(!vectors.back().allFinite())
      throw std::invalid_argument("point " + std::to_string(i) + " is not finite");
  }
  return to_points(vectors, traits);
}

// A negative index becomes a very large one, which no point has.
template <typename Matrix>
std::vector<std::array<std::size_t, 2>> rows_to_edges(const Eigen::MatrixBase<Matrix>& matrix)
{
  static_assert(std::is_integral_v<typename Matrix::Scalar>, "indices are integers");
  CGAL_precondition_msg(matrix.cols() == 2, "`edges` has two columns");
  std::vector<std::array<std::size_t, 2>> edges;
  edges.reserve(static_cast<std::size_t>(matrix.rows()));
  for(Eigen::Index e = 0; e < matrix.rows(); ++e)
    edges.push_back(
        {static_cast<std::size_t>(matrix(e, 0)), static_cast<std::size_t>(matrix(e, 1))});
  return edges;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_GRAPH_H
