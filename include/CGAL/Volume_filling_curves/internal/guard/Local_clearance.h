// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_CLEARANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_CLEARANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_observer_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/search/Dynamic_box_tree.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Locator of the edges of a curve near a box, which observes the curve while it changes one node at
// a time. The boxes of the edges are collected at the first query, and again now and then, since
// the curve may have moved away, or grown beyond the frame of the boxes, as fingers from a small
// circle do. Linear time to build, logarithmic per change; a query takes near-constant time if
// edges are short or few, and only rounding adds edges that are not near.
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

  // Must be called after a change of the whole curve.
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
  static constexpr std::size_t updates_per_edge = 8; // before they are collected again

  void update_edges_at(std::size_t v)
  {
    for(std::size_t k = 0; k < m_curve.degree(v); ++k) update(m_curve.incident_edge(v, k));
  }

  void update(std::size_t e)
  {
    if(!m_is_built) return;
    m_boxes.set(e, box_of(e));
    const std::size_t n = (std::min)(m_number_of_collected, m_curve.number_of_edges());
    m_is_built = ++m_number_of_updates <= updates_per_edge * n;
  }

  Box box_of(std::size_t e) const { return Box(position(source(e))).extend(position(target(e))); }

  void build()
  {
    Box frame;
    for(const std::size_t e : m_curve.edges()) frame.extend(box_of(e));
    const std::size_t n = m_curve.number_of_edges() + m_curve.number_of_removed_edges();
    m_boxes = Dynamic_box_tree(
        frame, n, [&](std::size_t e) { return m_curve.is_removed_edge(e) ? Box() : box_of(e); });
    m_number_of_collected = m_curve.number_of_edges();
    m_number_of_updates = 0;
    m_is_built = true;
  }

  const Network& m_curve;
  Dynamic_box_tree m_boxes;
  std::size_t m_number_of_collected = 0;
  std::size_t m_number_of_updates = 0; // since the boxes were collected
  bool m_is_built = false;
};

// Clearance rule for a change that replaces a few edges by others with a common node b: remaining
// edges keep their distance from the new ones, and new ones from each other, relative to the
// situation before. In double arithmetic. Constant time for edges of similar lengths.
template <typename Network>
class Local_clearance
{
public:
  // An edge between two nodes; the positions of its ends may differ from those of the nodes.
  struct Edge
  {
    std::size_t node, other; // `other` may be the null node
    Vector at_node, at_other;
  };

  using Edges = boost::container::small_vector<Edge, 2>;

  explicit Local_clearance(Edge_locator<Network>& curve) : m_curve(curve) {}

  // Returns whether the clearance is kept where new edges replace old ones. Moved edges are
  // compared one by one with their former positions, in the order given; others with all edges that
  // they replace.
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
