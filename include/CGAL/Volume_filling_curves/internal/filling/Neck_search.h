// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_NECK_SEARCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_NECK_SEARCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/Path_search.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Distance_to_curve.h>

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Proof that only passages narrower than r lead from a curve to a point: a breadth-first search on
// a grid would find a path of a ball of radius r / 2 from the point to within r of the curve. A
// search that ends without one is the proof; one that takes too long proves nothing. Linear in the
// number of visited cells, which is limited.
template <typename Network, typename Domain>
class Neck_search
{
  using Traits = typename Network::Traits;

public:
  // The search ends without a proof once `must_stop` returns true.
  Neck_search(const Network& curve, const Domain& domain, std::function<bool()> must_stop)
      : m_curve(curve),
        m_paths(domain, curve.traits(), max_cells),
        m_must_stop(std::move(must_stop))
  {}

  // returns whether every passage from a point to the curve is proved to be narrower than r.
  // \pre the ball of radius r / 2 around the point lies inside
  bool is_behind_neck(const Vector& point, double r)
  {
    const auto is_end = [&](const Vector& p) {
      return m_cells_left-- <= 1 || m_curve.distance(p) < r || m_must_stop();
    };
    return m_cells_left > 0 && !m_paths.search(point, max_cell * r, is_end);
  }

private:
  // In units of r. If the center of a ball of radius r / 2 lies in a cell of size s, the center of
  // the cell is at least r / 2 - 0.87 s from the boundary; the search requires 0.55 s.
  static constexpr double max_cell = 0.35;
  static constexpr std::size_t max_cells = 300000;

  const Distance_to_curve m_curve;
  Path_search<Domain, Traits> m_paths;
  const std::function<bool()> m_must_stop;
  std::size_t m_cells_left = max_cells;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_NECK_SEARCH_H
