// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_ELEMENTARY_MOVE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_ELEMENTARY_MOVE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Filtered_triangle.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Criteria of elementary moves (Reidemeister 1926), the only changes of a curve: the sides ab, bc
// of a triangle replace ac, or ac replaces them, or a node moves in a straight line. The guard and
// the random search both use these functions; the replay of a certificate shares nothing with them.
// Exact. Constant time for edges of similar lengths.
//
// A `Curve` finds nearby edges: holds_near(box, f) returns whether f(e) holds for all edges e near
// a box, source(e) and target(e) return the nodes of an edge, position(v) that of a node.
//
// A clearance, which is not part of the proof, may refuse more than contacts: distance() is its
// range around the triangle, allows_at_a(p) and allows_at_c(p) test an edge from that corner to p,
// and allows(p, q) tests any other edge pq.

struct No_clearance
{
  static constexpr double distance() { return 0; }
  static constexpr bool allows_at_a(const Vector&) { return true; }
  static constexpr bool allows_at_c(const Vector&) { return true; }
  static constexpr bool allows(const Vector&, const Vector&) { return true; }
};

// Returns whether the closed triangle abc meets the curve, except for edges e with is_taken_out(e),
// only in its corner a, and in its corner c if c is a node: `Curve`'s null node stands for a corner
// that is not a node.
template <typename Curve, typename Node, typename Traits, typename IsTakenOut, typename Clearance>
bool is_triangle_free(Curve& curve,
                      Node node_a,
                      Node node_c,
                      const Filtered_triangle<Traits>& triangle,
                      const IsTakenOut& is_taken_out,
                      const Clearance& clearance)
{
  const double distance = clearance.distance();
  return curve.holds_near(inflated(triangle.box(), distance), [&](auto e) {
    if(is_taken_out(e)) return true;
    const Node s = curve.source(e), t = curve.target(e);
    const bool is_at_a = s == node_a || t == node_a, is_at_c = s == node_c || t == node_c;
    if(is_at_a && is_at_c) return false; // the edge ac is there already
    const Vector &p = curve.position(s), &q = curve.position(t);
    if(is_at_a) {
      const Vector& far = s == node_a ? q : p;
      return !triangle.meets_beyond_a(far) && clearance.allows_at_a(far);
    }
    if(is_at_c) {
      const Vector& far = s == node_c ? q : p;
      return !triangle.meets_beyond_c(far) && clearance.allows_at_c(far);
    }
    return (distance > 0 && triangle.is_far_from_plane(p, q, distance)) ||
           (!triangle.meets(p, q) && clearance.allows(p, q));
  });
}

// Returns whether ac may replace the edges ab and bc, or the reverse: if they lie on a line, b must
// lie strictly between a and c, which keeps the curve the same set.
template <typename Curve, typename Node, typename Traits, typename IsTakenOut, typename Clearance>
bool can_exchange_sides(Curve& curve,
                        Node node_a,
                        Node node_c,
                        const Filtered_triangle<Traits>& triangle,
                        const IsTakenOut& is_taken_out,
                        const Clearance& clearance)
{
  if(triangle.is_flat()) return triangle.is_b_between();
  return is_triangle_free(curve, node_a, node_c, triangle, is_taken_out, clearance);
}

// returns whether a node that moves from b to its target passes between its neighbors a and c: it
// hits neither of them, and meets the line ac, if at all, only strictly between them. That and the
// free triangles of a, b, target and of c, b, target are all that is needed for the move.
template <typename Traits>
bool passes_between(
    const Vector& a, const Vector& c, const Vector& b, const Vector& target, const Traits& traits)
{
  if(Filtered_triangle<Traits>(a, c, b, traits).side(target) != 0) return true;
  const Exact_predicates<Traits> predicates(traits);
  const auto p = to_point(a, traits), r = to_point(c, traits);
  const auto q = to_point(b, traits), s = to_point(target, traits);
  return !predicates.is_on_segment(p, q, s) && !predicates.is_on_segment(r, q, s) &&
         !predicates.does_segment_meet_line_outside(q, s, p, r);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_ELEMENTARY_MOVE_H
