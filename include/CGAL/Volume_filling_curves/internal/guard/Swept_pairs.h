// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_SWEPT_PAIRS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_SWEPT_PAIRS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Motion of all nodes from `before` to `after`, one node after another in the order of their
// indices or in the reverse order. When a node moves, its predecessors in this order have moved and
// its successors have not. Every test therefore reads known positions, and the proof
// consists of independent tests of single edges and pairs of edges: if all pass, the motion is an
// ambient isotopy (Reidemeister 1926, elementary moves). The tests are exact and
// take constant time, apart from questions to the domain.
template <typename Network>
class Swept_pairs
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Traits::Point_3;

public:
  Swept_pairs(const Network& curve,
              const std::vector<Point_3>& before,
              const std::vector<Point_3>& after,
              bool is_reversed)
      : m_curve(curve),
        m_predicates(curve.traits()),
        m_before(before),
        m_after(after),
        m_is_reversed(is_reversed)
  {}

  // returns whether no end of edge e passes through the other end
  bool is_edge_safe(std::size_t e) const
  {
    const std::size_t a = m_curve.source(e), b = m_curve.target(e);
    return !passes_through(a, b) && !passes_through(b, a);
  }

  // returns whether the edges e and f meet at no time. \pre they have no common node
  bool is_pair_safe(std::size_t e, std::size_t f) const
  {
    const std::size_t a = m_curve.source(e), b = m_curve.target(e);
    const std::size_t c = m_curve.source(f), d = m_curve.target(f);
    return !does_sweep_meet(a, b, c, d) && !does_sweep_meet(b, a, c, d) &&
           !does_sweep_meet(c, d, a, b) && !does_sweep_meet(d, c, a, b);
  }

  // returns whether the edges ab and bc meet only in b at all times
  bool is_corner_safe(std::size_t a, std::size_t b, std::size_t c) const
  {
    return !does_sweep_meet_beyond_corner(a, b, c) && !does_sweep_meet_beyond_corner(c, b, a) &&
           !does_leave_between(a, b, c);
  }

  // returns whether the triangles that the edges at v sweep while v moves lie inside the boundary
  template <typename Boundary>
  bool is_node_inside(std::size_t v, const Boundary& boundary) const
  {
    if(is_still(v)) return true;
    for(std::size_t k = 0; k < m_curve.degree(v); ++k)
      if(!boundary.is_triangle_inside(m_before[v], m_after[v], position(m_curve.neighbor(v, k), v)))
        return false;
    return true;
  }

private:
  // the position of w while v moves
  const Point_3& position(std::size_t w, std::size_t v) const
  {
    return (w < v) != m_is_reversed ? m_after[w] : m_before[w];
  }

  bool is_still(std::size_t v) const { return m_predicates.are_equal(m_before[v], m_after[v]); }

  bool passes_through(std::size_t v, std::size_t w) const
  {
    return !is_still(v) && m_predicates.is_on_segment(position(w, v), m_before[v], m_after[v]);
  }

  // whether the triangle that the edge vw sweeps while v moves meets the edge xy
  bool does_sweep_meet(std::size_t v, std::size_t w, std::size_t x, std::size_t y) const
  {
    return !is_still(v) &&
           m_predicates.does_segment_meet_triangle(position(x, v), position(y, v), position(w, v),
                                                   m_before[v], m_after[v]);
  }

  // whether the triangle that the edge vw sweeps while v moves meets the edge wx outside w
  bool does_sweep_meet_beyond_corner(std::size_t v, std::size_t w, std::size_t x) const
  {
    return !is_still(v) && m_predicates.does_segment_meet_triangle_beyond_corner(
                               position(w, v), position(x, v), m_before[v], m_after[v]);
  }

  // whether v meets the line ac outside the open segment ac while it moves
  bool does_leave_between(std::size_t a, std::size_t v, std::size_t c) const
  {
    return !is_still(v) && m_predicates.does_segment_meet_line_outside(
                               m_before[v], m_after[v], position(a, v), position(c, v));
  }

  const Network& m_curve;
  Exact_predicates<Traits> m_predicates;
  const std::vector<Point_3>& m_before;
  const std::vector<Point_3>& m_after;
  bool m_is_reversed;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_SWEPT_PAIRS_H
