// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_EDGE_LOCATOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_EDGE_LOCATOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Box_grid.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Finds the edges of a curve that come near a box, while the curve changes one node at a time.
// The grid is built when first asked; an edge that changes is inserted again, and what the grid
// still knows of its former place is only a candidate too many. It is built anew before these
// outnumber the edges. Linear to build, amortized constant time per query and change for edges of
// similar lengths.
template <typename Network>
class Edge_locator
{
public:
  explicit Edge_locator(const Network& curve) : m_curve(curve) {}

  // says that boxes asked for are larger than edges by up to this distance
  void set_query_margin(double margin)
  {
    m_margin = margin;
    reset();
  }

  // forgets everything: the curve has changed altogether
  void reset() { m_is_built = false; }

  void update(std::size_t e)
  {
    if(!m_is_built) return;
    m_grid.insert(e, box_of(e));
    m_is_built = ++m_number_of_updates <= m_curve.number_of_edges();
  }

  // Calls f(e) for every edge whose box overlaps `box`, possibly more than once, until f returns
  // false. Returns whether f never did.
  template <typename Function>
  bool holds_near(const Box& box, const Function& f)
  {
    if(!m_is_built) build();
    bool holds = true;
    m_grid.for_each_near(box, [&](std::size_t e) {
      if(holds && !m_curve.is_removed_edge(e) && do_overlap(box, box_of(e))) holds = f(e);
    });
    return holds;
  }

private:
  static constexpr double cell_per_edge = 1.5; // and at least the margin: a query visits few cells

  Box box_of(std::size_t e) const
  {
    Box box = Box::of(to_vector(m_curve.point(m_curve.source(e))));
    return box += to_vector(m_curve.point(m_curve.target(e)));
  }

  void build()
  {
    double sum = 0;
    std::size_t n = 0;
    for_each_edge([&](std::size_t e) {
      sum += box_of(e).longest_side();
      ++n;
    });
    const double mean = sum > 0 ? sum / static_cast<double>(n) : 1;
    const double cell_size = (std::max)(cell_per_edge * mean, m_margin);
    const Vector origin = n > 0 ? to_vector(m_curve.point(0)) : Vector(Vector::Zero());
    m_grid = Box_grid(origin, cell_size, n);
    for_each_edge([&](std::size_t e) { m_grid.insert(e, box_of(e)); });
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
  Box_grid m_grid;
  double m_margin = 0;
  std::size_t m_number_of_updates = 0; // since the grid was built
  bool m_is_built = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_EDGE_LOCATOR_H
