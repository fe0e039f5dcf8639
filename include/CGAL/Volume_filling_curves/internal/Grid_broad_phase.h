// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GRID_BROAD_PHASE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GRID_BROAD_PHASE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Box_grid.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The box of everything that edge e is while its ends move from `before` to `after`.
template <typename Network>
Box swept_box(const Network& curve,
              std::size_t e,
              const Vector_field& before,
              const Vector_field& after)
{
  Box box = Box::of(row(before, curve.source(e)));
  box += row(before, curve.target(e));
  box += row(after, curve.source(e));
  box += row(after, curve.target(e));
  return box;
}

// Finds the pairs of edges that could meet or come close during a motion: those whose swept boxes,
// inflated by half the margin, overlap. Boxes in a hash grid; linear time for edges of similar
// lengths.
template <typename Network>
class Grid_broad_phase
{
public:
  Grid_broad_phase(const Network& curve,
                   const Vector_field& before,
                   const Vector_field& after,
                   double margin)
  {
    const std::size_t n = curve.number_of_edges();
    m_boxes.reserve(n);
    double sum_of_sides = 0;
    for(std::size_t e = 0; e < n; ++e) {
      m_boxes.push_back(swept_box(curve, e, before, after).inflated(margin / 2));
      sum_of_sides += m_boxes.back().longest_side();
    }
    const double mean_side = n > 0 && sum_of_sides > 0 ? sum_of_sides / static_cast<double>(n) : 1;
    m_grid = Box_grid(n > 0 ? m_boxes[0].min : Vector(Vector::Zero()), cell_per_box * mean_side, n);
    for(std::size_t e = 0; e < n; ++e) m_grid.insert(e, m_boxes[e]);
  }

  // Calls f(j) once for every candidate j < e.
  template <typename Function>
  void for_each_candidate_below(std::size_t e, const Function& f) const
  {
    m_grid.for_each_overlap_below(e, m_boxes, f);
  }

private:
  static constexpr double cell_per_box = 2; // 1 puts a box into 8 cells on average, 2 into 3.4

  std::vector<Box> m_boxes;
  Box_grid m_grid;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GRID_BROAD_PHASE_H
