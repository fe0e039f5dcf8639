// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REMESHING_REMESHER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REMESHING_REMESHER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Keeps edge lengths between h and 2h, where h may vary from node to node, by certified operations
// (section 4.4 of the paper). An edge shorter than h loses one of its ends; where that would leave
// an edge longer than 2h, which would be split again, the end moves to the middle of its neighbors
// instead. Edges longer than 2h are split in the middle. What the guard refuses stays as it is.
// Linear.
template <typename Guard>
class Remesher
{
  using Network = typename Guard::Curve_network;
  using Traits = typename Network::Traits;

public:
  // Takes h for each node; an edge has the mean of its ends.
  Remesher(Guard& guard, std::vector<double> spacing)
      : m_guard(guard), m_curve(guard.curve()), m_spacing(std::move(spacing))
  {}

  // Leaves garbage in the network if it changes anything but positions.
  void collapse_short_edges()
  {
    for(const std::size_t e : m_curve.edges())
      if(length(e) < spacing(e)) collapse(e);
  }

  void split_long_edges()
  {
    for(const std::size_t e : m_curve.edges()) // those that were there at first
      if(length(e) > 2 * spacing(e)) split(e);
  }

  std::size_t number_of_refusals() const { return m_number_of_refusals; }

private:
  Vector position(std::size_t v) const { return to_vector(m_curve.point(v)); }

  double length(std::size_t e) const { return edge_vector(m_curve, e).norm(); }

  double spacing(std::size_t e) const
  {
    return (m_spacing[m_curve.source(e)] + m_spacing[m_curve.target(e)]) / 2;
  }

  bool can_remove(std::size_t v) const { return m_curve.degree(v) == 2 && !m_curve.is_pinned(v); }

  // the length of the edge that would replace node v
  double length_without(std::size_t v) const
  {
    return (position(m_curve.neighbor(v, 0)) - position(m_curve.neighbor(v, 1))).norm();
  }

  void collapse(std::size_t e)
  {
    std::size_t first = m_curve.source(e), second = m_curve.target(e);
    if(!can_remove(first)) std::swap(first, second);
    if(!can_remove(first)) return;
    if(can_remove(second) && length_without(second) < length_without(first))
      std::swap(first, second);
    if(length_without(first) > 2 * m_spacing[first])
      count(m_guard.move_node(first, middle(first)));
    else if(!m_guard.remove_node(first))
      count(can_remove(second) && length_without(second) <= 2 * m_spacing[second] &&
            m_guard.remove_node(second));
  }

  void split(std::size_t e)
  {
    const double h = spacing(e);
    const bool is_done = halve_edge(m_guard, e);
    if(is_done) m_spacing.push_back(h);
    count(is_done);
  }

  typename Traits::Point_3 middle(std::size_t v) const
  {
    return to_point(
        Vector((position(m_curve.neighbor(v, 0)) + position(m_curve.neighbor(v, 1))) / 2),
        m_curve.traits());
  }

  void count(bool is_done) { m_number_of_refusals += is_done ? 0 : 1; }

  Guard& m_guard;
  const Network& m_curve;
  std::vector<double> m_spacing; // per node
  std::size_t m_number_of_refusals = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REMESHING_REMESHER_H
