// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_CHANGE_CERTIFIER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_CHANGE_CERTIFIER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/guard/Local_bends.h>
#include <CGAL/Volume_filling_curves/internal/guard/Local_clearance.h>
#include <CGAL/Volume_filling_curves/internal/guard/elementary_move.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Certifier of single changes, in which a node moves, is inserted or is removed: tests whether the
// change is an elementary move of knot theory, stays inside the domain, and keeps the clearance and
// the limits of bends. A new ray must meet the curve only in its end, stay inside, and keep the
// clearance. Constant time for edges of similar lengths.
template <typename Network, typename Boundary>
class Local_change_certifier
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Traits::Point_3;
  using Edge = typename Local_clearance<Network>::Edge;
  using Edges = typename Local_clearance<Network>::Edges;

public:
  Local_change_certifier(const Network& curve,
                         const Exact_predicates<Traits>& predicates,
                         Edge_locator<Network>& locator,
                         const Boundary& boundary)
      : m_curve(curve),
        m_predicates(predicates),
        m_locator(locator),
        m_clearance(locator),
        m_bends(curve, locator),
        m_boundary(boundary)
  {}

  // \pre target differs from the position of v
  bool is_move_safe(std::size_t v,
                    const Point_3& target,
                    const Clearance_rule& clearance,
                    const Bend_limits<Point_3>& bends) const
  {
    if(!passes_between_neighbors(v, target)) return false;
    const Taken_out is_at_v{m_curve, v, none};
    const Vector start = position(v), end = to_vector(target);
    Edges old_edges, new_edges;
    for(std::size_t k = 0; k < m_curve.degree(v); ++k) {
      const std::size_t a = m_curve.neighbor(v, k);
      const Filtered_triangle<Traits> triangle(position(a), start, end, m_curve.traits());
      if(!is_triangle_free(m_locator, a, none, triangle, is_at_v, No_clearance()) ||
         !is_inside(m_curve.point(v), target, m_curve.point(a)))
        return false;
      old_edges.push_back({a, v, position(a), start});
      new_edges.push_back({a, v, position(a), end});
    }
    return are_kept(old_edges, new_edges, clearance, bends, is_at_v);
  }

  bool is_insertion_safe(std::size_t e,
                         const Point_3& b,
                         const Clearance_rule& clearance,
                         const Bend_limits<Point_3>& bends) const
  {
    const std::size_t a = m_curve.source(e), c = m_curve.target(e);
    const Taken_out is_e{m_curve, none, e};
    if(!can_exchange(a, b, c, is_e)) return false;
    const Edge old_edge = {a, c, position(a), position(c)};
    const Edge ab = {a, none, position(a), to_vector(b)}, cb = {c, none, position(c), to_vector(b)};
    return are_kept({old_edge}, {ab, cb}, clearance, bends, is_e);
  }

  bool is_removal_safe(std::size_t v,
                       const Clearance_rule& clearance,
                       const Bend_limits<Point_3>& bends) const
  {
    if(m_curve.degree(v) != 2) return false;
    const std::size_t a = m_curve.neighbor(v, 0), c = m_curve.neighbor(v, 1);
    const Taken_out is_at_v{m_curve, v, none};
    if(!can_exchange(a, m_curve.point(v), c, is_at_v)) return false;
    const Edge ab = {a, v, position(a), position(v)}, cb = {c, v, position(c), position(v)};
    const Edge new_edge = {a, c, position(a), position(c)};
    return are_kept({ab, cb}, {new_edge}, clearance, bends, is_at_v);
  }

  // whether an edge from an end of the curve to a new node meets nothing but that end
  bool is_ray_safe(std::size_t end, const Point_3& tip, const Clearance_rule& clearance) const
  {
    if(m_curve.degree(end) != 1 || m_predicates.are_equal(m_curve.point(end), tip)) return false;
    const Taken_out is_nothing{m_curve, none, none};
    const Vector a = position(end), b = to_vector(tip);
    const Filtered_triangle<Traits> segment(a, b, b, m_curve.traits());
    return is_triangle_free(m_locator, end, none, segment, is_nothing, No_clearance()) &&
           is_inside(m_curve.point(end), tip, tip) &&
           m_clearance.is_kept({}, {{end, none, a, b}}, clearance, is_nothing);
  }

private:
  static constexpr std::size_t none = Network::null_node();

  // The edges of a node, or an edge. One type for all changes: that spares the compiler two thirds
  // of the functions that visit edges.
  struct Taken_out
  {
    const Network& curve;
    std::size_t node, edge;

    bool operator()(std::size_t e) const
    {
      return e == edge || curve.source(e) == node || curve.target(e) == node;
    }
  };

  bool are_kept(const Edges& old_edges,
                const Edges& new_edges,
                const Clearance_rule& clearance,
                const Bend_limits<Point_3>& bends,
                const Taken_out& is_taken_out) const
  {
    return m_clearance.is_kept(old_edges, new_edges, clearance, is_taken_out) &&
           m_bends.are_kept(old_edges, new_edges, bends, is_taken_out);
  }

  Vector position(std::size_t v) const { return to_vector(m_curve.point(v)); }

  // Returns whether v, moving to the target, hits no neighbor and passes between each two of them.
  bool passes_between_neighbors(std::size_t v, const Point_3& target) const
  {
    if(m_curve.degree(v) == 1)
      return !m_predicates.is_on_segment(m_curve.point(m_curve.neighbor(v, 0)), m_curve.point(v),
                                         target);
    for(std::size_t i = 0; i < m_curve.degree(v); ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(!passes_between(position(m_curve.neighbor(v, i)), position(m_curve.neighbor(v, j)),
                           position(v), to_vector(target), m_curve.traits()))
          return false;
    return true;
  }

  // whether the edge ac may be exchanged for the edges ab, bc, or these for it
  bool can_exchange(std::size_t a,
                    const Point_3& b,
                    std::size_t c,
                    const Taken_out& is_taken_out) const
  {
    const Filtered_triangle<Traits> triangle(position(a), to_vector(b), position(c),
                                             m_curve.traits());
    return can_exchange_sides(m_locator, a, c, triangle, is_taken_out, No_clearance()) &&
           (triangle.is_flat() || is_inside(m_curve.point(a), b, m_curve.point(c)));
  }

  bool is_inside(const Point_3& a, const Point_3& b, const Point_3& c) const
  {
    if constexpr(Boundary::is_bounded) return m_boundary.is_triangle_inside(a, b, c);
    return true;
  }

  const Network& m_curve;
  const Exact_predicates<Traits>& m_predicates;
  Edge_locator<Network>& m_locator;
  Local_clearance<Network> m_clearance;
  Local_bends<Network> m_bends;
  const Boundary& m_boundary;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_CHANGE_CERTIFIER_H
