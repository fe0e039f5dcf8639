// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_EXACT_PREDICATES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_EXACT_PREDICATES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tests whether a closed segment and a closed triangle meet, and whether they meet outside a common
// corner. Exact in all degenerate cases, since planar and collinear input is common, and CGAL's
// `do_intersect()` is unspecified for degenerate triangles. All decisions rest on three predicates
// of the traits: the orientation of four points, the orientation of three points in their plane,
// and lexicographic order along a line. Constant time.
template <typename Traits>
class Exact_predicates
{
public:
  using Point_3 = typename Traits::Point_3;

  explicit Exact_predicates(const Traits& traits)
      : m_orientation(traits.orientation_3_object()),
        m_coplanar_orientation(traits.coplanar_orientation_3_object()),
        m_less(traits.less_xyz_3_object())
  {}

  // returns whether the three points lie on a line
  bool are_collinear(const Point_3& a, const Point_3& b, const Point_3& c) const
  {
    return m_coplanar_orientation(a, b, c) == COLLINEAR;
  }

  bool are_coplanar(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d) const
  {
    return m_orientation(a, b, c, d) == COPLANAR;
  }

  bool are_equal(const Point_3& a, const Point_3& b) const
  {
    return !m_less(a, b) && !m_less(b, a);
  }

  // returns whether q lies strictly between p and r. \pre p, q, r are collinear
  bool is_strictly_between(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return (m_less(p, q) && m_less(q, r)) || (m_less(r, q) && m_less(q, p));
  }

  // returns whether q lies on the closed segment pr, which may be a point
  bool is_on_segment(const Point_3& q, const Point_3& p, const Point_3& r) const
  {
    return are_collinear(p, q, r) && is_between(p, q, r);
  }

  // returns whether the closed segments pq and rs meet; each may be a point
  bool do_segments_intersect(const Point_3& p,
                             const Point_3& q,
                             const Point_3& r,
                             const Point_3& s) const
  {
    return are_coplanar(p, q, r, s) && do_coplanar_segments_intersect(p, q, r, s);
  }

  // returns whether the closed segment pq meets the closed triangle abc, which may be degenerate
  bool does_segment_meet_triangle(const Point_3& p,
                                  const Point_3& q,
                                  const Point_3& a,
                                  const Point_3& b,
                                  const Point_3& c) const
  {
    const Orientation side_p = m_orientation(a, b, c, p), side_q = m_orientation(a, b, c, q);
    if(side_p == side_q && side_p != COPLANAR) return false;
    if(side_p != side_q) return does_line_meet_triangle(p, q, a, b, c);
    if(!are_collinear(a, b, c)) return does_coplanar_segment_meet_triangle(p, q, a, b, c);
    const auto [first, last] = hull_of_collinear_points(a, b, c);
    return do_segments_intersect(p, q, first, last);
  }

  // returns whether the closed segment ps meets the closed triangle pqr, which may be degenerate,
  // anywhere but in p. \pre s differs from p
  bool does_segment_meet_triangle_beyond_corner(const Point_3& p,
                                                const Point_3& s,
                                                const Point_3& q,
                                                const Point_3& r) const
  {
    if(m_orientation(p, q, r, s) != COPLANAR) return false;
    const Orientation turn = m_coplanar_orientation(p, q, r);
    if(turn == COLLINEAR) return have_same_direction(p, s, q) || have_same_direction(p, s, r);
    // s - p lies in the closed cone of q - p and r - p
    const Orientation from_q = m_coplanar_orientation(p, q, s);
    const Orientation to_r = m_coplanar_orientation(p, s, r);
    if(from_q == COLLINEAR) return have_same_direction(p, s, q);
    if(to_r == COLLINEAR) return have_same_direction(p, s, r);
    return from_q == turn && to_r == turn;
  }

  // returns whether the segments ps and pq have more than p in common. \pre s and q differ from p
  bool have_same_direction(const Point_3& p, const Point_3& s, const Point_3& q) const
  {
    return are_collinear(p, s, q) && !are_equal(p, q) && !is_between(s, p, q);
  }

  // returns whether the closed segment bc meets the line ad outside the open segment ad
  // \pre a differs from d
  bool does_segment_meet_line_outside(const Point_3& b,
                                      const Point_3& c,
                                      const Point_3& a,
                                      const Point_3& d) const
  {
    if(!are_coplanar(a, d, b, c)) return false;
    const Orientation side_b = m_coplanar_orientation(a, d, b);
    const Orientation side_c = m_coplanar_orientation(a, d, c);
    if(side_b == COLLINEAR && !is_strictly_between(a, b, d)) return true;
    if(side_c == COLLINEAR && !is_strictly_between(a, c, d)) return true;
    if(side_b == COLLINEAR || side_c == COLLINEAR || side_b == side_c) return false;
    return m_coplanar_orientation(b, c, a) == m_coplanar_orientation(b, c, d) ||
           m_coplanar_orientation(b, c, a) == COLLINEAR ||
           m_coplanar_orientation(b, c, d) == COLLINEAR;
  }

private:
  bool is_between(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return (!m_less(q, p) && !m_less(r, q)) || (!m_less(q, r) && !m_less(p, q));
  }

  std::pair<Point_3, Point_3> hull_of_collinear_points(const Point_3& a,
                                                       const Point_3& b,
                                                       const Point_3& c) const
  {
    const auto range = std::minmax({a, b, c}, m_less);
    return {range.first, range.second};
  }

  // \pre not both p and q lie in the plane of abc, nor both strictly on one side of it
  bool does_line_meet_triangle(const Point_3& p,
                               const Point_3& q,
                               const Point_3& a,
                               const Point_3& b,
                               const Point_3& c) const
  {
    const Orientation turns[] = {m_orientation(p, q, a, b), m_orientation(p, q, b, c),
                                 m_orientation(p, q, c, a)};
    const auto has = [&](Orientation turn) { return std::count(turns, turns + 3, turn) > 0; };
    return !(has(POSITIVE) && has(NEGATIVE));
  }

  // \pre the four points are coplanar
  bool do_coplanar_segments_intersect(const Point_3& p,
                                      const Point_3& q,
                                      const Point_3& r,
                                      const Point_3& s) const
  {
    const Orientation pqr = m_coplanar_orientation(p, q, r), pqs = m_coplanar_orientation(p, q, s);
    const Orientation rsp = m_coplanar_orientation(r, s, p), rsq = m_coplanar_orientation(r, s, q);
    if(pqr == COLLINEAR && is_between(p, r, q)) return true;
    if(pqs == COLLINEAR && is_between(p, s, q)) return true;
    if(rsp == COLLINEAR && is_between(r, p, s)) return true;
    if(rsq == COLLINEAR && is_between(r, q, s)) return true;
    return pqr * pqs < 0 && rsp * rsq < 0;
  }

  // \pre abc is not degenerate, p and q lie in its plane
  bool does_coplanar_segment_meet_triangle(const Point_3& p,
                                           const Point_3& q,
                                           const Point_3& a,
                                           const Point_3& b,
                                           const Point_3& c) const
  {
    const Orientation abp = m_coplanar_orientation(a, b, p), bcp = m_coplanar_orientation(b, c, p);
    const Orientation cap = m_coplanar_orientation(c, a, p), abc = m_coplanar_orientation(a, b, c);
    if(abp != -abc && bcp != -abc && cap != -abc) return true;
    return do_coplanar_segments_intersect(p, q, a, b) ||
           do_coplanar_segments_intersect(p, q, b, c) || do_coplanar_segments_intersect(p, q, c, a);
  }

  typename Traits::Orientation_3 m_orientation;
  typename Traits::Coplanar_orientation_3 m_coplanar_orientation;
  typename Traits::Less_xyz_3 m_less;
};

// Intersection test of two closed triangles. Exact, and each of them may be a segment or a point,
// for which CGAL's `do_intersect()` is unspecified: they meet if and only if an edge of one meets
// the other. The plane of one of them separates most pairs beforehand. Constant time.
template <typename Traits>
class Triangle_intersection
{
public:
  using Triangle = std::array<typename Traits::Point_3, 3>;

  explicit Triangle_intersection(const Traits& traits = Traits())
      : m_orientation(traits.orientation_3_object()), m_predicates(traits)
  {}

  bool do_intersect(const Triangle& s, const Triangle& t) const
  {
    if(is_on_one_side(s, t) || is_on_one_side(t, s)) return false;
    return does_boundary_meet(s, t) || does_boundary_meet(t, s);
  }

private:
  bool is_on_one_side(const Triangle& plane, const Triangle& t) const
  {
    const Orientation side = m_orientation(plane[0], plane[1], plane[2], t[0]);
    return side != COPLANAR && m_orientation(plane[0], plane[1], plane[2], t[1]) == side &&
           m_orientation(plane[0], plane[1], plane[2], t[2]) == side;
  }

  bool does_boundary_meet(const Triangle& s, const Triangle& t) const
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(m_predicates.does_segment_meet_triangle(s[i], s[(i + 1) % 3], t[0], t[1], t[2]))
        return true;
    return false;
  }

  typename Traits::Orientation_3 m_orientation;
  Exact_predicates<Traits> m_predicates;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_EXACT_PREDICATES_H
