// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_EDGE_CONTACTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_EDGE_CONTACTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/replay/Replayed_curve.h>
#include <CGAL/Volume_filling_curves/internal/replay/rational_geometry.h>
#include <CGAL/Volume_filling_curves/internal/replay/separating_directions.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Contacts of the edges of a replayed curve. Exact: rational numbers decide where double arithmetic
// cannot. Borrows the curve.
class Edge_contacts
{
  using Triangle = std::array<Position, 3>;

public:
  explicit Edge_contacts(const Replayed_curve& curve) : m_curve(curve) {}

  // returns whether two edges meet outside of a common node
  bool do_meet(std::size_t e, std::size_t f) const
  {
    for(const std::size_t v : {m_curve.source(e), m_curve.target(e)})
      if(m_curve.is_at(f, v)) {
        const Position &p = point(m_curve.opposite(v, e)), &q = point(m_curve.opposite(v, f));
        return p == point(v) || q == point(v) ||
               (!is_surely_outside_cone(point(v), p, q, q) &&
                is_in_cone_exactly(point(v), p, q, q));
      }
    const Position &p = point(m_curve.source(f)), &q = point(m_curve.target(f));
    return meets_triangle(e, {p, q, q});
  }

  // returns whether edge f meets a triangle elsewhere than in those of its corners a (the first)
  // and c (the last) that are nodes of f
  bool is_in_the_way(std::size_t f, const Triangle& triangle, std::size_t a, std::size_t c) const
  {
    if(m_curve.is_at(f, a))
      return is_in_cone(a, f, triangle[1], triangle[2]) || m_curve.is_at(f, c);
    if(m_curve.is_at(f, c)) return is_in_cone(c, f, triangle[0], triangle[1]);
    return meets_triangle(f, triangle);
  }

private:
  const Position& point(std::size_t v) const { return m_curve.point(v); }

  bool is_in_cone(std::size_t apex, std::size_t f, const Position& q, const Position& r) const
  {
    const Position& s = point(m_curve.opposite(apex, f));
    return !is_surely_outside_cone(point(apex), s, q, r) &&
           is_in_cone_exactly(point(apex), s, q, r);
  }

  bool meets_triangle(std::size_t e, const Triangle& triangle) const
  {
    const std::array<Position, 2> segment = {point(m_curve.source(e)), point(m_curve.target(e))};
    Extent segment_box, box;
    for(const Position& p : segment) segment_box.add(p);
    for(const Position& p : triangle) box.add(p);
    return box.meets(segment_box) && !are_surely_apart(segment, triangle) &&
           do_meet_exactly(segment[0], segment[1], triangle);
  }

  const Replayed_curve& m_curve;
};

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_EDGE_CONTACTS_H
