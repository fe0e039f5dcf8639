// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PATH_SEARCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PATH_SEARCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for paths inside a domain, around corners and through necks: breadth first over the cells
// of a grid whose centers have enough clearance; the path back is pulled taut. The size of the
// cells is a power of two, hence searches from different points share them and skip regions without
// a result. Linear in the number of visited cells, which is limited.
template <typename Domain, typename Traits>
class Path_search
{
  using Point_3 = typename Traits::Point_3;

public:
  // Takes how many cells may be visited in all.
  Path_search(const Domain& domain, const Traits& traits, std::size_t most_cells)
      : m_domain(domain), m_traits(traits), m_cells_left(most_cells)
  {
    const auto box = domain.bbox();
    m_origin = Vector(box.xmin(), box.ymin(), box.zmin());
  }

  // Floods the domain from a place on, in cells of at most that size, and shows their centers, the
  // place first, to `is_end` until it returns true. Returns whether it did.
  template <typename IsEnd>
  bool flood(const Vector& start, double largest_cell, const IsEnd& is_end)
  {
    m_start = start;
    m_level = std::ilogb(largest_cell);
    m_size = std::ldexp(1, m_level);
    m_former = {}; // clear() would keep, and fill, millions of buckets for a few cells
    std::deque<Cell> queue(1, cell_at(start));
    if(m_fruitless.count(queue.front()) > 0 || !has_room(queue.front())) return false;
    m_former[queue.front()] = queue.front();
    while(!queue.empty() && m_cells_left > 0) {
      m_last = queue.front();
      queue.pop_front();
      --m_cells_left;
      if(is_end(position(m_last))) return true;
      for(const Cell& next : neighbors(m_last))
        if(m_former.count(next) == 0 && has_room(next)) {
          m_former[next] = m_last;
          queue.push_back(next);
        }
    }
    for(const auto& [cell, former] : m_former) m_fruitless.insert(cell);
    return false;
  }

  // the centers of the cells on the way, the last one shown first
  std::vector<Vector> cells() const
  {
    std::vector<Vector> cells(1, position(m_last));
    for(Cell c = m_last; m_former.at(c) != c; c = m_former.at(c))
      cells.push_back(position(m_former.at(c)));
    return cells;
  }

  // The places on the way from a place that sees the last cell shown to the start of the flood, no
  // two of which are farther apart than `longest`, without the former.
  std::vector<Vector> way_from(const Vector& p, double longest) const
  {
    const std::vector<Vector> places = cells();
    std::vector<Vector> way;
    Vector from = p;
    for(std::size_t k = 0; k + 1 < places.size(); ++k) {
      const bool is_next_near = (places[k + 1] - from).norm() <= longest;
      if(is_next_near && sees(from, places[k + 1])) continue;
      way.push_back(from = places[k]);
    }
    way.push_back(m_start);
    return way;
  }

  // returns whether the straight way has room
  bool sees(const Vector& p, const Vector& q) const
  {
    const double length = (q - p).norm();
    const double needed = (std::min)({room_of_cell * m_size, room(p), room(q)}) / 2;
    if(!(needed > 0)) return false;
    for(double done = 0; done < length;) {
      const double free = room(p + done / length * (q - p));
      if(free < needed) return false;
      done += free;
    }
    return true;
  }

private:
  using Cell = std::array<std::int64_t, 4>; // the place in the grid, and the size's exponent

  static constexpr bool is_plane = Space_of<Domain>::is_plane;

  // At the center, in units of the size: balls around neighboring centers meet.
  static constexpr double room_of_cell = 0.55;

  Cell cell_at(const Vector& p) const
  {
    Cell c{0, 0, 0, m_level};
    for(std::size_t i = 0; i < 3; ++i)
      c[i] = std::llround(std::floor((p - m_origin)[static_cast<int>(i)] / m_size));
    return c;
  }

  // the center, but where the flood begins
  Vector position(const Cell& c) const
  {
    if(m_former.at(c) == c) return m_start;
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

  bool has_room(const Cell& c) const { return room(center(c)) >= room_of_cell * m_size; }

  // the distance to the boundary, 0 outside
  double room(const Vector& x) const { return depth(m_domain, to_point(x, m_traits)); }

  const Domain& m_domain;
  const Traits m_traits;
  std::size_t m_cells_left;
  Vector m_origin;
  std::unordered_set<Cell, boost::hash<Cell>> m_fruitless;

  // of the last flood
  Vector m_start;
  int m_level = 0;
  double m_size = 0; // of the cells
  Cell m_last{};
  std::unordered_map<Cell, Cell, boost::hash<Cell>> m_former; // from which a cell was reached
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PATH_SEARCH_H
