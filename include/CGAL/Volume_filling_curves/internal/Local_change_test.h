// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_LOCAL_CHANGE_TEST_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_LOCAL_CHANGE_TEST_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Box.h>
#include <CGAL/Volume_filling_curves/internal/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/Edge_locator.h>
#include <CGAL/Volume_filling_curves/internal/Triangle_test.h>
#include <CGAL/Volume_filling_curves/internal/exact_predicates.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tests for replacing edges of a curve by others that share one node b: edges that are not taken
// out must miss the triangles between old and new ones (exact), and stay away from the new ones
// (the clearance rule, in double arithmetic). Constant time for edges of similar lengths.
template <typename Network>
class Local_change_test
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Traits::Point_3;

public:
  // An edge between two nodes, where the other end may stand elsewhere than the node does.
  struct Edge
  {
    std::size_t node, other; // `other` may be the null node
    Point_3 at_node, at_other;
  };

  using Edges = boost::container::small_vector<Edge, 2>;

  Local_change_test(const Network& curve,
                    const Exact_predicates<Traits>& predicates,
                    Edge_locator<Network>& locator)
      : m_curve(curve), m_predicates(predicates), m_locator(locator)
  {}

  // returns whether the closed triangle (a, b, c) meets the curve, but for the edges e with
  // is_taken_out(e), only in its corner a, and in its corner c if that is a node. Null stands for a
  // corner that is no node.
  template <typename IsTakenOut>
  bool is_triangle_free(std::size_t node_a,
                        std::size_t node_c,
                        const Point_3& a,
                        const Point_3& b,
                        const Point_3& c,
                        const IsTakenOut& is_taken_out) const
  {
    Box box = Box::of(to_vector(a));
    box += to_vector(b);
    box += to_vector(c);
    const Triangle_test triangle(to_vector(a), to_vector(b), to_vector(c));
    return m_locator.holds_near(box, [&](std::size_t e) {
      if(is_taken_out(e)) return true;
      const std::size_t s = m_curve.source(e), t = m_curve.target(e);
      const bool is_at_a = s == node_a || t == node_a, is_at_c = s == node_c || t == node_c;
      if(is_at_a && is_at_c) return false;
      if(is_at_a) return !meets_beyond_corner(e, node_a, b, c);
      if(is_at_c) return !meets_beyond_corner(e, node_c, a, b);
      return triangle.is_missed(to_vector(m_curve.point(s)), to_vector(m_curve.point(t))) ||
             !m_predicates.does_segment_meet_triangle(m_curve.point(s), m_curve.point(t), a, b, c);
    });
  }

  // returns whether the other edges keep their clearance from the new edges, and the new edges
  // their opening at b. Moved edges are compared one by one with what they were, in the order given;
  // others with all that they replace.
  template <typename IsTakenOut>
  bool keeps_clearance(const Edges& old_edges,
                       const Edges& new_edges,
                       const Clearance_rule& rule,
                       const IsTakenOut& is_taken_out) const
  {
    if(!rule.is_active()) return true;
    const bool is_move = old_edges.size() == new_edges.size();
    for(std::size_t k = 0; k < new_edges.size(); ++k) {
      const Edge& edge = new_edges[k];
      const Edges former = is_move ? Edges{old_edges[k]} : old_edges;
      Box box = Box::of(to_vector(edge.at_node));
      box += to_vector(edge.at_other);
      const bool is_free = m_locator.holds_near(box.inflated(rule.distance()), [&](std::size_t e) {
        return is_taken_out(e) || is_clear(e, edge, former, rule);
      });
      if(!is_free) return false;
      for(std::size_t l = 0; l < k; ++l)
        if(!rule.allows_opening(opening_between(edge, new_edges[l]), [&] {
             return is_move ? opening_between(old_edges[k], old_edges[l]) : straight_opening;
           }))
          return false;
    }
    return true;
  }

private:
  static constexpr double straight_opening = 2;

  // the opening at b, the other end of both edges
  static double opening_between(const Edge& e, const Edge& f)
  {
    return Clearance_rule::opening(to_vector(e.at_node), to_vector(e.at_other),
                                   to_vector(f.at_node));
  }

  bool meets_beyond_corner(std::size_t e,
                           std::size_t corner,
                           const Point_3& q,
                           const Point_3& r) const
  {
    const std::size_t other = m_curve.source(e) == corner ? m_curve.target(e) : m_curve.source(e);
    return m_predicates.does_segment_meet_triangle_beyond_corner(m_curve.point(corner),
                                                                 m_curve.point(other), q, r);
  }

  bool is_clear(std::size_t e,
                const Edge& edge,
                const Edges& old_edges,
                const Clearance_rule& rule) const
  {
    for(std::size_t end : {m_curve.source(e), m_curve.target(e)}) {
      const std::size_t far = m_curve.source(e) == end ? m_curve.target(e) : m_curve.source(e);
      if(end == edge.node) return is_opening_clear(end, far, edge.at_other, old_edges, rule);
      if(end == edge.other) return is_opening_clear(end, far, edge.at_node, old_edges, rule);
    }
    return rule.allows_distance(squared_distance(e, edge), [&] {
      double least = std::numeric_limits<double>::infinity();
      for(const Edge& old : old_edges) least = (std::min)(least, squared_distance(e, old));
      return least;
    });
  }

  // the corner (far, node, new_end), compared with the corner that an old edge had there
  bool is_opening_clear(std::size_t node,
                        std::size_t far,
                        const Point_3& new_end,
                        const Edges& old_edges,
                        const Clearance_rule& rule) const
  {
    const auto opening = [&](const Point_3& end) {
      return Clearance_rule::opening(to_vector(m_curve.point(far)), to_vector(m_curve.point(node)),
                                     to_vector(end));
    };
    return rule.allows_opening(opening(new_end), [&] {
      double least = straight_opening;
      for(const Edge& old : old_edges) {
        if(old.node == node) least = (std::min)(least, opening(old.at_other));
        if(old.other == node) least = (std::min)(least, opening(old.at_node));
      }
      return least;
    });
  }

  double squared_distance(std::size_t e, const Edge& edge) const
  {
    return squared_segment_distance(to_vector(m_curve.point(m_curve.source(e))),
                                    to_vector(m_curve.point(m_curve.target(e))),
                                    to_vector(edge.at_node), to_vector(edge.at_other));
  }

  const Network& m_curve;
  const Exact_predicates<Traits>& m_predicates;
  Edge_locator<Network>& m_locator;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_LOCAL_CHANGE_TEST_H
