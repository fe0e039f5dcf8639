// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_CERTIFIER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_CERTIFIER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/arcs/Arc_spline.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Pairs of pieces of an arc spline that meet outside a common end. Each arc is represented by the
// closed triangle of its ends and its corner. Exact in all degenerate cases. Boxes are in the order
// of the curve, as `Box_tree` requires: near-linear time.
template <typename Traits>
class Arc_contacts
{
  using Point_3 = typename Traits::Point_3;
  using Piece = Arc_spline_piece<Point_3>;
  using Triangle = std::array<Point_3, 3>;

public:
  // \pre the points of a triangle are distinct; segments meet one another in common ends only
  Arc_contacts(const Arc_spline<Point_3>& spline, const Traits& traits)
      : m_predicates(traits), m_triangles(traits)
  {
    for(const Arc_spline_path<Point_3>& path : spline.paths)
      for(const Piece& piece : path.pieces) m_pieces.push_back(&piece);
  }

  // Calls f(piece, other) for every pair of pieces in contact, in a fixed order. \throws
  // Run_stopped
  template <typename Function>
  void for_each(Run_watch& watch, const Function& f) const
  {
    unsigned counter = 0;
    for_each_overlapping_pair(Box_tree(boxes()), [&](std::size_t i, std::size_t j) {
      watch.check_sometimes(counter);
      const Piece &s = *m_pieces[i], &t = *m_pieces[j];
      if((s.is_arc() || t.is_arc()) && are_in_contact(s, t)) f(s, t);
    });
  }

private:
  std::vector<Bbox_3> boxes() const
  {
    std::vector<Bbox_3> boxes;
    for(const Piece* const piece : m_pieces) {
      Box box;
      for(const Point_3& p : triangle(*piece)) box.extend(to_vector(p));
      boxes.push_back(to_bbox(box));
    }
    return boxes;
  }

  // A segment is a degenerate triangle: its second end counts twice.
  static Triangle triangle(const Piece& piece)
  {
    return {piece.start, piece.is_arc() ? piece.corner : piece.end, piece.end};
  }

  // the same, from the end of the piece
  static Triangle reversed(const Piece& piece)
  {
    return {piece.end, piece.is_arc() ? piece.corner : piece.start, piece.start};
  }

  // Pieces have at most one end in common, since an embedded polygon has at least three corners.
  bool are_in_contact(const Piece& s, const Piece& t) const
  {
    for(const Triangle& a : {triangle(s), reversed(s)})
      for(const Triangle& b : {triangle(t), reversed(t)})
        if(m_predicates.are_equal(a[0], b[0])) return do_meet_beyond(a, b) || do_meet_beyond(b, a);
    return m_triangles.do_intersect(triangle(s), triangle(t));
  }

  // whether an edge of a meets b outside their common first corner
  bool do_meet_beyond(const Triangle& a, const Triangle& b) const
  {
    return m_predicates.does_segment_meet_triangle_beyond_corner(b[0], a[1], b[1], b[2]) ||
           m_predicates.does_segment_meet_triangle_beyond_corner(b[0], a[2], b[1], b[2]) ||
           m_predicates.does_segment_meet_triangle(a[1], a[2], b[0], b[1], b[2]);
  }

  Exact_predicates<Traits> m_predicates;
  Triangle_intersection<Traits> m_triangles;
  std::vector<const Piece*> m_pieces;
};

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

  // Returns the square of the distance from the start of an arc to the line of one of the edges at
  // the corner, in a unit that is the same for both edges.
  double distance_from_edge(const Piece& arc, std::size_t k) const
  {
    const Vector p = to_vector(arc.corner),
                 q = to_vector(m_copy.point(m_copy.neighbor(arc.node, k)));
    return in_own_units(to_vector(arc.start) - p)
        .cross(in_own_units(q - p).normalized())
        .squaredNorm();
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
