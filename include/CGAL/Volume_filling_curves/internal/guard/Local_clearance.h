// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_CLEARANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_CLEARANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/guard/Edge_locator.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The clearance rule where a few edges are replaced by others that share one node b: the edges that
// stay keep away from the new ones, and the new ones from each other, compared with what was there
// before. In double arithmetic. Constant time for edges of similar lengths.
template <typename Network>
class Local_clearance
{
public:
  // An edge between two nodes, where the other end may stand elsewhere than the node does.
  struct Edge
  {
    std::size_t node, other; // `other` may be the null node
    Vector at_node, at_other;
  };

  using Edges = boost::container::small_vector<Edge, 2>;

  explicit Local_clearance(Edge_locator<Network>& curve) : m_curve(curve) {}

  // returns whether the clearance is kept where new edges replace old ones. Moved edges are
  // compared one by one with what they were, in the order given; others with all that they replace.
  template <typename IsTakenOut>
  bool is_kept(const Edges& old_edges,
               const Edges& new_edges,
               const Clearance_rule& rule,
               const IsTakenOut& is_taken_out) const
  {
    if(!rule.is_active()) return true;
    const bool is_move = old_edges.size() == new_edges.size();
    for(std::size_t k = 0; k < new_edges.size(); ++k) {
      const Edge& edge = new_edges[k];
      if(!is_clear(edge, is_move ? Edges{old_edges[k]} : old_edges, rule, is_taken_out))
        return false;
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
    return Clearance_rule::opening(e.at_node, e.at_other, f.at_node);
  }

  // whether a new edge is clear of all that stay
  template <typename IsTakenOut>
  bool is_clear(const Edge& edge,
                const Edges& old_edges,
                const Clearance_rule& rule,
                const IsTakenOut& is_taken_out) const
  {
    const Box box = Box(edge.at_node).extend(edge.at_other);
    return m_curve.holds_near(inflated(box, rule.distance()), [&](std::size_t e) {
      return is_taken_out(e) || is_clear_of(e, edge, old_edges, rule);
    });
  }

  bool is_clear_of(std::size_t e,
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
                        const Vector& new_end,
                        const Edges& old_edges,
                        const Clearance_rule& rule) const
  {
    const auto opening = [&](const Vector& end) {
      return Clearance_rule::opening(m_curve.position(far), m_curve.position(node), end);
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
    return squared_segment_distance(m_curve.position(m_curve.source(e)),
                                    m_curve.position(m_curve.target(e)), edge.at_node,
                                    edge.at_other);
  }

  Edge_locator<Network>& m_curve;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_CLEARANCE_H
