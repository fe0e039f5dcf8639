// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STEP_SINGLE_MOVES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STEP_SINGLE_MOVES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Moves the nodes of a curve one by one, each as far towards its target as that is certified, where
// no part of the motion of all of them is: a node that is in the way, as one next to a wall, then
// holds nobody but itself. Logarithmic time per node for most curves.
template <typename Guard>
class Single_moves
{
public:
  explicit Single_moves(Guard& guard) : m_guard(guard) {}

  // returns the fraction of the way that the nodes went on average
  double operator()(const Vector_field& targets)
  {
    const std::size_t n = m_guard.curve().number_of_nodes();
    double sum = 0;
    for(std::size_t v = 0; v < n; ++v)
      if(!m_guard.curve().is_pinned(v)) sum += move(v, row(targets, v));
    return n > 0 ? sum / static_cast<double>(n) : 0;
  }

private:
  double move(std::size_t v, const Vector& target)
  {
    const Vector start = to_vector(m_guard.curve().point(v));
    for(const double fraction : {1., 0.5, 0.125}) {
      const Vector x = start + fraction * (target - start);
      if(m_guard.move_node(v, to_point(x, m_guard.curve().traits()))) return fraction;
    }
    return 0;
  }

  Guard& m_guard;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STEP_SINGLE_MOVES_H
