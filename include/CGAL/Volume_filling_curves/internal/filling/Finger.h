// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Finger that grows out of an edge of a curve: the edge is halved, and one half is pulled out to a
// blunt tip, an edge across the path, by two insertions, each an elementary move that the guard
// certifies. Constant time apart from the guard's search.
template <typename Guard>
class Finger
{
  using Network = typename Guard::Curve_network;

public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Finger(Guard& guard, std::size_t edge) : m_guard(guard), m_edge(edge) {}

  // The length of an edge as seen from a point: the longer, the better a finger grows from it.
  static double span(const Network& curve, std::size_t e, const Vector& p)
  {
    const Vector a = to_vector(curve.point(curve.source(e)));
    const Vector b = to_vector(curve.point(curve.target(e)));
    return across(b - a, p - (a + b) / 2).norm();
  }

  // Halves the edge and returns the second half, or none if the guard refuses. \pre it is whole
  std::size_t halve()
  {
    if(halve_edge(m_guard, m_edge)) m_half = edge_after(m_edge);
    return m_half;
  }

  // Pulls the finger to a tip of the given half width around p, whose ends must both have enough
  // clearance; returns whether it has grown.
  template <typename HasClearance>
  bool grow(const Vector& p, double half_width, const HasClearance& has_clearance)
  {
    const Vector a = position(curve().source(m_edge));
    const Vector b = position(curve().target(m_half == none ? m_edge : m_half));
    const Vector side = half_width * across(b - a, p - (a + b) / 2).normalized();
    if(!has_clearance(p - side) || !has_clearance(p + side)) return false;
    if(m_half == none && halve() == none) return false;
    if(!insert(m_half, p - side)) return false;
    const std::size_t first = curve().target(m_half), rest = edge_after(m_half);
    if(!insert(rest, p + side)) {
      m_guard.remove_node(first);
      return false;
    }
    m_tip = rest;
    return true;
  }

  // Undoes the halving of the edge. \pre the finger has not grown
  void withdraw()
  {
    if(m_half != none && m_guard.remove_node(curve().target(m_edge))) m_half = none;
  }

  // the edge of the tip. \pre the finger has grown
  std::size_t tip() const { return m_tip; }

  // the edges of the sides, which lead to the tip and back. \pre the finger has grown
  std::array<std::size_t, 2> sides() const { return {m_half, edge_after(m_tip)}; }

private:
  const Network& curve() const { return m_guard.curve(); }

  Vector position(std::size_t v) const { return to_vector(curve().point(v)); }

  static Vector across(const Vector& v, const Vector& direction)
  {
    return v - v.dot(direction) / direction.squaredNorm() * direction;
  }

  bool insert(std::size_t e, const Vector& p)
  {
    return m_guard.insert_node(e, to_point(p, curve().traits()));
  }

  // the edge that an inserted node joins to e
  std::size_t edge_after(std::size_t e) const
  {
    const std::size_t v = curve().target(e);
    return curve().incident_edge(v, curve().incident_edge(v, 0) == e ? 1 : 0);
  }

  Guard& m_guard;
  std::size_t m_edge;
  std::size_t m_half = none, m_tip = none; // the second half of the edge; the tip
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_H
