// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_BENDS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_BENDS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Strand_neighbors.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/guard/Local_clearance.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Limits of bends and of the distance between strands in a change that replaces a few edges by
// others: one edge by two to a new node, two by one, or the edges of a node that moves. Constant
// time for edges of similar lengths.
template <typename Network>
class Local_bends
{
  using Point_3 = typename Network::Point_3;
  using Edge = typename Local_clearance<Network>::Edge;
  using Edges = typename Local_clearance<Network>::Edges;
  using Limits = Bend_limits<Point_3>;

public:
  Local_bends(const Network& curve, Edge_locator<Network>& locator)
      : m_curve(curve), m_locator(locator)
  {}

  // returns whether the limits are kept where new edges replace old ones: moved edges in the same
  // order; the `node` of an edge stays where it is
  template <typename IsTakenOut>
  bool are_kept(const Edges& old_edges,
                const Edges& new_edges,
                const Limits& limits,
                const IsTakenOut& is_taken_out) const
  {
    if(!limits.is_active()) return true;
    for(std::size_t k = 0; k < new_edges.size(); ++k) {
      const Edge& edge = new_edges[k];
      if(!is_outer_corner_kept(edge.node, edge.at_other, old_edges, limits, is_taken_out))
        return false;
      if(new_edges.size() == 1 &&
         !is_outer_corner_kept(edge.other, edge.at_node, old_edges, limits, is_taken_out))
        return false;
    }
    if(new_edges.size() == 2 && !is_inner_corner_kept(old_edges, new_edges, limits)) return false;
    for(std::size_t k = 0; k < new_edges.size(); ++k)
      if(!is_distance_kept(k, old_edges, new_edges, limits, is_taken_out)) return false;
    return true;
  }

private:
  double scale_at(const Vector& p, const Limits& limits) const
  {
    return limits.scale ? limits.scale(to_point(p, m_curve.traits())) : 1;
  }

  // The corner at a node that stays, between an edge that stays and a new one to `new_end`.
  template <typename IsTakenOut>
  bool is_outer_corner_kept(std::size_t v,
                            const Vector& new_end,
                            const Edges& old_edges,
                            const Limits& limits,
                            const IsTakenOut& is_taken_out) const
  {
    if(m_curve.degree(v) != 2) return true;
    const std::size_t k = is_taken_out(m_curve.incident_edge(v, 0)) ? 1 : 0;
    const Vector p = m_locator.position(v);
    const Vector in = p - m_locator.position(m_curve.neighbor(v, k));
    return keeps_limit(bend_radius(in, new_end - p), limits.bend_radius * scale_at(p, limits), [&] {
      for(const Edge& old : old_edges) {
        if(old.node == v) return bend_radius(in, old.at_other - p);
        if(old.other == v) return bend_radius(in, old.at_node - p);
      }
      return std::numeric_limits<double>::infinity();
    });
  }

  // The corner at a node that moves or is new; before, a new one is straight.
  bool is_inner_corner_kept(const Edges& old_edges,
                            const Edges& new_edges,
                            const Limits& limits) const
  {
    const auto radius = [](const Edges& edges) {
      return bend_radius(edges[0].at_other - edges[0].at_node,
                         edges[1].at_node - edges[1].at_other);
    };
    return keeps_limit(radius(new_edges),
                       limits.bend_radius * scale_at(new_edges[0].at_other, limits), [&] {
                         return old_edges.size() == 2 ? radius(old_edges)
                                                      : std::numeric_limits<double>::infinity();
                       });
  }

  // The distance of the k-th new edge to other strands.
  template <typename IsTakenOut>
  bool is_distance_kept(std::size_t k,
                        const Edges& old_edges,
                        const Edges& new_edges,
                        const Limits& limits,
                        const IsTakenOut& is_taken_out) const
  {
    if(!(limits.strand_distance > 0)) return true;
    const Edge& edge = new_edges[k];
    const double scale =
        (std::min)(scale_at(edge.at_node, limits), scale_at(edge.at_other, limits));
    const Box box =
        inflated(Box(edge.at_node).extend(edge.at_other), scale * limits.strand_distance);
    std::vector<std::size_t> neighbors; // found when they are first needed
    return m_locator.holds_near(box, [&](std::size_t e) {
      if(is_taken_out(e)) return true;
      const double d = limits.strand_distance * (std::min)(scale, edge_scale(e, limits));
      const double after = squared_distance(e, edge);
      if(after >= d * d || after >= squared_distance_before(e, k, old_edges, new_edges))
        return true;
      if(neighbors.empty())
        neighbors = edges_within(m_curve, ends_of_paths(k, new_edges),
                                 scale * limits.length_between_strands(), is_taken_out);
      return std::binary_search(neighbors.begin(), neighbors.end(), e);
    });
  }

  double edge_scale(std::size_t e, const Limits& limits) const
  {
    return (std::min)(limits.scale_at(m_curve.point(m_curve.source(e))),
                      limits.scale_at(m_curve.point(m_curve.target(e))));
  }

  // A moved edge is compared with its former position, others with all edges that they replace.
  double squared_distance_before(std::size_t e,
                                 std::size_t k,
                                 const Edges& old_edges,
                                 const Edges& new_edges) const
  {
    if(old_edges.size() == new_edges.size()) return squared_distance(e, old_edges[k]);
    double least = std::numeric_limits<double>::infinity();
    for(const Edge& old : old_edges) least = (std::min)(least, squared_distance(e, old));
    return least;
  }

  double squared_distance(std::size_t e, const Edge& edge) const
  {
    return squared_segment_distance(m_locator.position(m_curve.source(e)),
                                    m_locator.position(m_curve.target(e)), edge.at_node,
                                    edge.at_other);
  }

  // The nodes at which paths to other edges begin, with their distances from the k-th new edge
  // along the new ones.
  static std::vector<std::pair<double, std::size_t>> ends_of_paths(std::size_t k,
                                                                   const Edges& new_edges)
  {
    if(new_edges.size() == 1) return {{0., new_edges[0].node}, {0., new_edges[0].other}};
    std::vector<std::pair<double, std::size_t>> ends;
    for(std::size_t l = 0; l < new_edges.size(); ++l) {
      const Edge& edge = new_edges[l];
      ends.push_back({l == k ? 0. : (edge.at_other - edge.at_node).norm(), edge.node});
    }
    return ends;
  }

  const Network& m_curve;
  Edge_locator<Network>& m_locator;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_LOCAL_BENDS_H
