// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_CONTACTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_CONTACTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/arcs/Arc_spline.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Pairs of pieces of an arc spline that meet outside a common end. Each arc is
// represented by the closed triangle of its ends and its corner. Exact in all degenerate cases.
// Boxes are in the order of the curve, as `Box_tree` requires: near-linear time.
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

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_CONTACTS_H
