// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_LOCAL_CHANGE_CERTIFIER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_LOCAL_CHANGE_CERTIFIER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Local_change_test.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Decides whether a node may move, be inserted or be removed: whether the change is an elementary
// move of knot theory (Reidemeister 1926), stays inside the walls and keeps the clearance. The criteria are those of the
// table in the manual. Constant time for edges of similar lengths.
template <typename Network, typename Walls>
class Local_change_certifier
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Traits::Point_3;
  using Change_test = Local_change_test<Network>;
  using Edge = typename Change_test::Edge;

public:
  Local_change_certifier(const Network& curve,
                         const Exact_predicates<Traits>& predicates,
                         Edge_locator<Network>& locator,
                         const Walls& walls)
      : m_curve(curve), m_predicates(predicates), m_test(curve, predicates, locator), m_walls(walls)
  {}

  // \pre target differs from the position of v
  bool is_move_safe(std::size_t v, const Point_3& target, const Clearance_rule& clearance) const
  {
    if(!passes_between_neighbors(v, target)) return false;
    const Point_3& start = m_curve.point(v);
    const auto is_at_v = [&](std::size_t e) { return is_incident(e, v); };
    typename Change_test::Edges old_edges, new_edges;
    for(std::size_t k = 0; k < m_curve.degree(v); ++k) {
      const std::size_t a = m_curve.neighbor(v, k);
      if(!m_test.is_triangle_free(a, m_curve.null_node(), m_curve.point(a), start, target,
                                  is_at_v) ||
         !is_inside(start, target, m_curve.point(a)))
        return false;
      old_edges.push_back({a, v, m_curve.point(a), start});
      new_edges.push_back({a, v, m_curve.point(a), target});
    }
    return m_test.keeps_clearance(old_edges, new_edges, clearance, is_at_v);
  }

  bool is_insertion_safe(std::size_t e, const Point_3& b, const Clearance_rule& clearance) const
  {
    const std::size_t a = m_curve.source(e), c = m_curve.target(e), none = m_curve.null_node();
    const auto is_e = [&](std::size_t f) { return f == e; };
    if(!is_corner_move_safe(a, b, c, is_e)) return false;
    const Edge old_edge = {a, c, m_curve.point(a), m_curve.point(c)};
    const Edge ab = {a, none, m_curve.point(a), b}, cb = {c, none, m_curve.point(c), b};
    return m_test.keeps_clearance({old_edge}, {ab, cb}, clearance, is_e);
  }

  bool is_removal_safe(std::size_t v, const Clearance_rule& clearance) const
  {
    if(m_curve.degree(v) != 2) return false;
    const std::size_t a = m_curve.neighbor(v, 0), c = m_curve.neighbor(v, 1);
    const Point_3& b = m_curve.point(v);
    const auto is_at_v = [&](std::size_t e) { return is_incident(e, v); };
    if(are_adjacent(a, c) || !is_corner_move_safe(a, b, c, is_at_v)) return false;
    const Edge ab = {a, v, m_curve.point(a), b}, cb = {c, v, m_curve.point(c), b};
    const Edge new_edge = {a, c, m_curve.point(a), m_curve.point(c)};
    return m_test.keeps_clearance({ab, cb}, {new_edge}, clearance, is_at_v);
  }

private:
  bool is_incident(std::size_t e, std::size_t v) const
  {
    return m_curve.source(e) == v || m_curve.target(e) == v;
  }

  bool are_adjacent(std::size_t a, std::size_t c) const
  {
    for(std::size_t k = 0; k < m_curve.degree(a); ++k)
      if(m_curve.neighbor(a, k) == c) return true;
    return false;
  }

  // whether v, on its way to the target, hits no neighbor and passes between each two of them
  bool passes_between_neighbors(std::size_t v, const Point_3& target) const
  {
    const Point_3& start = m_curve.point(v);
    for(std::size_t i = 0; i < m_curve.degree(v); ++i) {
      const Point_3& a = m_curve.point(m_curve.neighbor(v, i));
      if(m_predicates.is_on_segment(a, start, target)) return false;
      for(std::size_t j = 0; j < i; ++j)
        if(m_predicates.does_segment_meet_line_outside(start, target, a,
                                                       m_curve.point(m_curve.neighbor(v, j))))
          return false;
    }
    return true;
  }

  // The elementary move between the edge ac and the edges ab, bc.
  template <typename IsTakenOut>
  bool is_corner_move_safe(std::size_t node_a,
                           const Point_3& b,
                           std::size_t node_c,
                           const IsTakenOut& is_taken_out) const
  {
    const Point_3 &a = m_curve.point(node_a), &c = m_curve.point(node_c);
    if(m_predicates.are_collinear(a, b, c)) return m_predicates.is_strictly_between(a, b, c);
    return m_test.is_triangle_free(node_a, node_c, a, b, c, is_taken_out) && is_inside(a, b, c);
  }

  bool is_inside(const Point_3& a, const Point_3& b, const Point_3& c) const
  {
    if constexpr(Walls::is_bounded) return m_walls.is_triangle_inside(a, b, c);
    return true;
  }

  const Network& m_curve;
  const Exact_predicates<Traits>& m_predicates;
  Change_test m_test;
  const Walls& m_walls;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_LOCAL_CHANGE_CERTIFIER_H
