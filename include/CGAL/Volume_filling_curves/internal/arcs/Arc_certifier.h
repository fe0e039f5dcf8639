// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_CERTIFIER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_CERTIFIER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/arcs/Arc_contacts.h>
#include <CGAL/Volume_filling_curves/internal/arcs/Arc_spline.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Proof that an arc spline is isotopic to its curve, inside the domain. The ends of arcs lie on
// edges up to rounding, so the guard inserts them into a copy of the curve. Each arc lies in the
// triangle of its ends and its corner. If this triangle meets the copy and all other triangles only
// in common ends, the arc can replace the two sides at the corner.
template <typename Traits, typename Domain>
class Arc_certifier
{
  using Network = Curve_network_3<Traits>;
  using Point_3 = typename Traits::Point_3;
  using Spline = Arc_spline<Point_3>;
  using Piece = Arc_spline_piece<Point_3>;

public:
  // \pre the curve is embedded, inside the domain
  Arc_certifier(const Network& curve, const Domain& domain, Run_watch& watch)
      : m_copy(curve), m_guard(m_copy, domain), m_watch(watch)
  {}

  // Sets `is_certified` and `conflicts`. \throws Run_stopped
  void operator()(Spline& spline)
  {
    for_each_arc(spline, [&](const Piece& arc) { insert_ends(arc); });
    if(m_conflicts.empty()) {
      find_contacts(spline);
      if constexpr(Guard::Boundary::is_bounded)
        for_each_arc(spline, [&](const Piece& arc) { check_inside(arc); });
    }
    spline.is_certified = m_conflicts.empty();
    spline.conflicts = one_per_node();
  }

private:
  using Guard = Isotopy_guard_3<Traits, Domain>;

  template <typename Function>
  void for_each_arc(const Spline& spline, const Function& f)
  {
    for(const Arc_spline_path<Point_3>& path : spline.paths)
      for(const Piece& piece : path.pieces) {
        m_watch.check_sometimes(m_counter);
        if(piece.is_arc()) f(piece);
      }
  }

  void insert_ends(const Piece& arc)
  {
    const std::size_t v = arc.node;
    const std::size_t k = distance_from_edge(arc, 0) < distance_from_edge(arc, 1) ? 0 : 1;
    if(!insert_end(v, k, arc.start) || !insert_end(v, 1 - k, arc.end))
      m_conflicts.push_back({v, Arc_obstacle::ROUNDING, v});
  }

  // Returns the distance from the start of an arc to the line of one of the edges at the corner.
  double distance_from_edge(const Piece& arc, std::size_t k) const
  {
    const Vector p = to_vector(arc.corner),
                 q = to_vector(m_copy.point(m_copy.neighbor(arc.node, k)));
    return (to_vector(arc.start) - p).cross((q - p).normalized()).squaredNorm();
  }

  // Inserts the end of an arc into an edge of v, unless the arc at the other end of the edge shares
  // it and has inserted it. Returns whether the node exists.
  bool insert_end(std::size_t v, std::size_t k, const Point_3& end)
  {
    return to_vector(m_copy.point(m_copy.neighbor(v, k))) == to_vector(end) ||
           m_guard.insert_node(m_copy.incident_edge(v, k), end);
  }

  void find_contacts(const Spline& spline)
  {
    const auto note = [&](const Piece& arc, const Piece& other) {
      if(arc.is_arc()) m_conflicts.push_back({arc.node, Arc_obstacle::STRAND, other.node});
    };
    Arc_contacts<Traits>(spline, m_copy.traits())
        .for_each(m_watch, [&](const Piece& piece, const Piece& other) {
          note(piece, other);
          note(other, piece);
        });
  }

  void check_inside(const Piece& arc)
  {
    if(!m_guard.boundary().is_triangle_inside(arc.start, arc.corner, arc.end))
      m_conflicts.push_back({arc.node, Arc_obstacle::BOUNDARY, arc.node});
  }

  std::vector<Arc_conflict> one_per_node()
  {
    const auto key = [](const Arc_conflict& c) { return std::tie(c.node, c.obstacle, c.other); };
    std::sort(m_conflicts.begin(), m_conflicts.end(),
              [&](const Arc_conflict& a, const Arc_conflict& b) { return key(a) < key(b); });
    m_conflicts.erase(
        std::unique(m_conflicts.begin(), m_conflicts.end(),
                    [](const Arc_conflict& a, const Arc_conflict& b) { return a.node == b.node; }),
        m_conflicts.end());
    return std::move(m_conflicts);
  }

  Network m_copy;
  Guard m_guard;
  Run_watch& m_watch;
  unsigned m_counter = 0;
  std::vector<Arc_conflict> m_conflicts;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_CERTIFIER_H
