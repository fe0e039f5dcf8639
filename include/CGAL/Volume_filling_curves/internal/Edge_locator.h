// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_EDGE_LOCATOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_EDGE_LOCATOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Box_blocks.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Finds the edges of a curve that come near a box, while the curve changes one node at a time.
// The boxes of the edges are collected when first asked for, and again now and then, since the curve
// may have left the place where they were. Linear to build, logarithmic time per change; a query
// takes near constant time for edges that are short or few, and no edge is found in vain but for
// rounding.
template <typename Network>
class Edge_locator
{
public:
  explicit Edge_locator(const Network& curve) : m_curve(curve) {}

  // forgets everything: the curve has changed altogether
  void reset() { m_is_built = false; }

  void update(std::size_t e)
  {
    if(!m_is_built) return;
    m_boxes.set(e, box_of(e));
    m_is_built = ++m_number_of_updates <= updates_per_edge * m_curve.number_of_edges();
  }

  // Calls f(e) for every edge whose box overlaps `box` until f returns false. Returns whether f never
  // did.
  template <typename Function>
  bool holds_near(const Box& box, const Function& f)
  {
    if(!m_is_built) build();
    return m_boxes.for_each_near(box, [&](std::size_t e) {
      if(!m_curve.is_removed_edge(e)) return !do_overlap(box, box_of(e)) || f(e);
      m_boxes.clear(e); // removed since it was found last
      return true;
    });
  }

private:
  static constexpr std::size_t updates_per_edge = 8; // before all is collected again

  Box box_of(std::size_t e) const
  {
    Box box = Box::of(to_vector(m_curve.point(m_curve.source(e))));
    return box += to_vector(m_curve.point(m_curve.target(e)));
  }

  void build()
  {
    Box frame = Box::of(Vector::Zero());
    bool is_empty = true;
    for_each_edge([&](std::size_t e) {
      const Box box = box_of(e);
      if(is_empty) frame = box;
      (frame += box.min) += box.max;
      is_empty = false;
    });
    m_boxes = Box_blocks(frame);
    for_each_edge([&](std::size_t e) { m_boxes.set(e, box_of(e)); });
    m_number_of_updates = 0;
    m_is_built = true;
  }

  template <typename Function>
  void for_each_edge(const Function& f) const
  {
    for(std::size_t e = 0; e < m_curve.number_of_edges(); ++e)
      if(!m_curve.is_removed_edge(e)) f(e);
  }

  const Network& m_curve;
  Box_blocks m_boxes;
  std::size_t m_number_of_updates = 0; // since the boxes were collected
  bool m_is_built = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_EDGE_LOCATOR_H
