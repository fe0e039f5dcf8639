// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_EDGE_LOCATOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_EDGE_LOCATOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_observer_3.h>
#include <CGAL/Volume_filling_curves/internal/search/Dynamic_box_tree.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Finds the edges of a curve that come near a box, and where they are, while the curve changes one
// node at a time, which it observes. The boxes of the edges are collected when first asked for, and
// again now and then, since the curve may have left the place where they were. Linear to build,
// logarithmic time per change; a query takes near constant time for edges that are short or few,
// and no edge is found in vain but for rounding.
template <typename Network>
class Edge_locator final : public Curve_network_observer_3<typename Network::Traits>
{
  using Base = Curve_network_observer_3<typename Network::Traits>;

public:
  using typename Base::Point_3;
  using typename Base::Rounds;

  explicit Edge_locator(const Network& curve) : m_curve(curve) {}

  void on_move(std::size_t v) override { update_edges_at(v); }
  void on_insertion(std::size_t v) override { update_edges_at(v); }
  void on_removal(std::size_t, std::size_t e) override { update(e); }
  void on_new_ray(std::size_t v) override { update_edges_at(v); }

  // The curve has changed altogether.
  void on_motion(const std::vector<Point_3>&, const Rounds&) override { m_is_built = false; }
  void on_renumbering(const std::vector<std::uint32_t>&) override { m_is_built = false; }

  std::size_t source(std::size_t e) const { return m_curve.source(e); }
  std::size_t target(std::size_t e) const { return m_curve.target(e); }
  Vector position(std::size_t v) const { return to_vector(m_curve.point(v)); }

  // Calls f(e) for every edge whose box overlaps `box` until f returns false. Returns whether f
  // never did.
  template <typename Function>
  bool holds_near(const Box& box, const Function& f)
  {
    if(!m_is_built) build();
    return m_boxes.holds_near(box, [&](std::size_t e) {
      if(!m_curve.is_removed_edge(e)) return !box.intersects(box_of(e)) || f(e);
      m_boxes.clear(e); // removed since it was found last
      return true;
    });
  }

private:
  static constexpr std::size_t updates_per_edge = 8; // before all is collected again

  void update_edges_at(std::size_t v)
  {
    for(std::size_t k = 0; k < m_curve.degree(v); ++k) update(m_curve.incident_edge(v, k));
  }

  void update(std::size_t e)
  {
    if(!m_is_built) return;
    m_boxes.set(e, box_of(e));
    m_is_built = ++m_number_of_updates <= updates_per_edge * m_curve.number_of_edges();
  }

  Box box_of(std::size_t e) const { return Box(position(source(e))).extend(position(target(e))); }

  void build()
  {
    Box frame;
    for(const std::size_t e : m_curve.edges()) frame.extend(box_of(e));
    const std::size_t n = m_curve.number_of_edges() + m_curve.number_of_removed_edges();
    m_boxes = Dynamic_box_tree(
        frame, n, [&](std::size_t e) { return m_curve.is_removed_edge(e) ? Box() : box_of(e); });
    m_number_of_updates = 0;
    m_is_built = true;
  }

  const Network& m_curve;
  Dynamic_box_tree m_boxes;
  std::size_t m_number_of_updates = 0; // since the boxes were collected
  bool m_is_built = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_EDGE_LOCATOR_H
