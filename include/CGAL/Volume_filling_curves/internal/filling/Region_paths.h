// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_REGION_PATHS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_REGION_PATHS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Thinned_paths.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Distance_to_curve.h>
#include <CGAL/Volume_filling_curves/internal/support/Deadline.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Paths inside a domain from regions that a curve does not get to, back to the curve: breadth first
// on a grid, whose edges must lie inside. Along a path the curve may be thinner for a while, so
// that it gets through necks that are too narrow for a loop. Linear in the number of cells visited,
// which is limited.
template <typename Network, typename Samples>
class Region_paths
{
  using Point_3 = typename Network::Point_3;
  using Region = Empty_region_3<Point_3>;

public:
  // Takes the edge length of the grid. After the deadline no further paths are looked for.
  Region_paths(const Network& curve,
               const Samples& samples,
               const std::vector<Region>& regions,
               double cell,
               const Deadline* deadline = nullptr)
      : m_samples(samples), m_tree(curve), m_cell(cell), m_deadline(deadline), m_paths(cell)
  {
    for(const Region& region : regions) find_path(to_vector(region.point));
  }

  const Thinned_paths& paths() const { return m_paths; }

private:
  static constexpr double reached = 2; // in cells, from the curve
  static constexpr std::size_t most_cells = 1000000;

  using Cell = std::array<std::int32_t, 3>;

  using Cells = std::unordered_map<Cell, Cell, boost::hash<Cell>>;

  Vector position(const Cell& c) const { return m_origin + m_cell * Vector(c[0], c[1], c[2]); }

  Point_3 point(const Cell& c) const { return to_point(position(c), m_samples.traits()); }

  void find_path(const Vector& start)
  {
    m_origin = start;
    Cells former; // the cell from which it was reached
    std::deque<Cell> queue(1, Cell{0, 0, 0});
    former[queue.front()] = queue.front();
    while(!queue.empty() && former.size() < most_cells && !is_late()) {
      const Cell c = queue.front();
      queue.pop_front();
      if(m_tree.distance(position(c)) < reached * m_cell) return add_path(former, c);
      for(std::size_t i = 0; i < 3; ++i)
        for(std::int32_t step : {-1, 1}) {
          Cell next = c;
          next[i] += step;
          if(former.count(next) != 0 || !is_inside(c, next)) continue;
          former[next] = c;
          queue.push_back(next);
        }
    }
  }

  bool is_late() const { return m_deadline && m_deadline->has_passed(); }

  bool is_inside(const Cell& from, const Cell& to) const
  {
    const Point_3 p = point(from), q = point(to);
    return m_samples.domain().is_triangle_inside(p, q, q);
  }

  void add_path(const Cells& former, Cell c)
  {
    for(; former.at(c) != c; c = former.at(c)) m_paths.add(position(c));
    m_paths.add(position(c));
  }

  const Samples& m_samples;
  Distance_to_curve m_tree;
  double m_cell;
  const Deadline* m_deadline;
  Vector m_origin;
  Thinned_paths m_paths;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_REGION_PATHS_H
