// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PATH_SEARCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PATH_SEARCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <CGAL/Bbox_3.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for paths inside a domain, around corners and through necks: breadth first over the cells
// of a grid whose centers are far enough from the boundary; the path back is pulled taut. The size
// of the cells is a power of two, hence searches from different points share them and skip regions
// without a result. Linear in the number of visited cells, which is limited.
template <typename Domain, typename Traits>
class Path_search
{
  using Point_3 = typename Traits::Point_3;

public:
  // Takes the limit of the number of visited cells, for all searches together.
  Path_search(const Domain& domain, const Traits& traits, std::size_t max_cells)
      : m_domain(domain), m_traits(traits), m_cells_left(max_cells)
  {
    const auto box = domain.bbox();
    m_origin = Vector(box.xmin(), box.ymin(), box.zmin());
  }

  // Visits the cells, of at most the given size, that are connected with the start: passes their
  // centers, first the start itself, to `is_end` until it returns true. Returns whether it did.
  template <typename IsEnd>
  bool search(const Vector& start, double max_cell_size, const IsEnd& is_end)
  {
    m_start = start;
    m_level = std::ilogb(max_cell_size);
    m_size = std::ldexp(1, m_level);
    m_predecessors = {}; // clear() would keep, and fill, millions of buckets for a few cells
    std::deque<Cell> queue(1, cell_at(start));
    if(m_without_result.count(queue.front()) > 0 || !has_clearance(queue.front())) return false;
    m_predecessors[queue.front()] = queue.front();
    while(!queue.empty() && m_cells_left > 0) {
      m_last = queue.front();
      queue.pop_front();
      --m_cells_left;
      if(is_end(position(m_last))) return true;
      for(const Cell& next : neighbors(m_last))
        if(m_predecessors.count(next) == 0 && has_clearance(next)) {
          m_predecessors[next] = m_last;
          queue.push_back(next);
        }
    }
    for(const auto& [cell, former] : m_predecessors) m_without_result.insert(cell);
    return false;
  }

  // the centers of the cells on the path found, from its end to the start
  std::vector<Vector> path() const
  {
    std::vector<Vector> path(1, position(m_last));
    for(Cell c = m_last; m_predecessors.at(c) != c; c = m_predecessors.at(c))
      path.push_back(position(m_predecessors.at(c)));
    return path;
  }

  // The points of the path, pulled taut, from a point that sees its end to the start, without the
  // point itself. Steps are no longer than `max_step`, as far as the cells allow.
  std::vector<Vector> path_from(const Vector& p, double max_step) const
  {
    const std::vector<Vector> centers = path();
    std::vector<Vector> taut;
    Vector from = p;
    for(std::size_t k = 0; k + 1 < centers.size(); ++k) {
      const bool is_next_near = (centers[k + 1] - from).norm() <= max_step;
      if(is_next_near && sees(from, centers[k + 1])) continue;
      taut.push_back(from = centers[k]);
    }
    taut.push_back(m_start);
    return taut;
  }

  // returns whether the segment keeps clear of the boundary
  bool sees(const Vector& p, const Vector& q) const
  {
    const double length = (q - p).norm();
    const double needed = (std::min)({cell_clearance * m_size, depth_at(p), depth_at(q)}) / 2;
    if(!(needed > 0)) return false;
    for(double done = 0; done < length;) {
      const double free = depth_at(p + done / length * (q - p));
      if(free < needed) return false;
      done += free;
    }
    return true;
  }

private:
  using Cell = std::array<std::int64_t, 4>; // indices in the grid, and the exponent of the size

  static constexpr bool is_plane = Space_of<Domain>::is_plane;

  // Required distance of a center to the boundary, in units of the size of the cell: balls around
  // neighboring centers meet.
  static constexpr double cell_clearance = 0.55;

  Cell cell_at(const Vector& p) const
  {
    Cell c{0, 0, 0, m_level};
    for(std::size_t i = 0; i < 3; ++i)
      c[i] = std::llround(std::floor((p - m_origin)[static_cast<int>(i)] / m_size));
    return c;
  }

  // the center of a cell, and the start in the first one
  Vector position(const Cell& c) const
  {
    if(m_predecessors.at(c) == c) return m_start;
    return center(c);
  }

  Vector center(const Cell& c) const
  {
    return m_origin + m_size * Vector(static_cast<double>(c[0]) + 0.5,
                                      static_cast<double>(c[1]) + 0.5,
                                      static_cast<double>(c[2]) + (is_plane ? 0 : 0.5));
  }

  static auto neighbors(const Cell& c)
  {
    constexpr std::size_t dimension = Space_of<Domain>::dimension;
    std::array<Cell, 2 * dimension> result;
    result.fill(c);
    for(std::size_t i = 0; i < dimension; ++i) {
      --result[2 * i][i];
      ++result[2 * i + 1][i];
    }
    return result;
  }

  bool has_clearance(const Cell& c) const { return depth_at(center(c)) >= cell_clearance * m_size; }

  // the distance to the boundary, 0 outside
  double depth_at(const Vector& x) const { return depth(m_domain, to_point(x, m_traits)); }

  const Domain& m_domain;
  const Traits m_traits;
  std::size_t m_cells_left;
  Vector m_origin;
  std::unordered_set<Cell, boost::hash<Cell>> m_without_result;

  // of the last search
  Vector m_start;
  int m_level = 0;
  double m_size = 0; // of a cell
  Cell m_last{};
  std::unordered_map<Cell, Cell, boost::hash<Cell>> m_predecessors; // of visited cells
};

// Domain from which a layer along the boundary and segments are removed, for the search for paths
// around them.
template <typename Domain>
class Domain_without_segments
{
public:
  using Point_3 = typename Domain::Point_3;
  using Segment = std::array<Vector, 2>;

  static constexpr int dimension = dimension_of<Domain>;

  Domain_without_segments(const Domain& domain, double layer) : m_domain(domain), m_layer(layer) {}

  void remove(const Vector& p, const Vector& q) { m_segments.push_back({p, q}); }
  void remove(const std::vector<Vector>& path)
  {
    for(std::size_t k = 1; k < path.size(); ++k) remove(path[k - 1], path[k]);
  }

  CGAL::Bbox_3 bbox() const { return m_domain.bbox(); }
  bool is_inside(const Point_3& p) const { return m_domain.is_inside(p) && distance(p) > 0; }

  double distance(const Point_3& p) const
  {
    return (std::min)(static_cast<double>(m_domain.distance(p)) - m_layer, distance_to_segments(p));
  }

private:
  double distance_to_segments(const Point_3& p) const
  {
    double least = std::numeric_limits<double>::infinity();
    for(const Segment& s : m_segments)
      least = (std::min)(least, squared_distance_to_segment(to_vector(p), s[0], s[1]));
    return std::sqrt(least);
  }

  const Domain& m_domain;
  const double m_layer;
  std::vector<Segment> m_segments;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PATH_SEARCH_H
