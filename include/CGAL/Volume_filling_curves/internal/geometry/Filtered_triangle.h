// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_FILTERED_TRIANGLE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_FILTERED_TRIANGLE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Filtered tests of segments against a closed triangle. Exact, but nearly always decided by a few
// products: both ends are clearly on the same side of the triangle's plane, or the segment clearly
// misses the triangle. The signs of 3 x 3 determinants are trusted if they exceed an error bound
// (Shewchuk 1997; similar to CGAL's filters, with precomputed terms); the remaining cases use the
// exact predicates of the traits. Constant time, no allocation.
template <typename Traits>
class Filtered_triangle
{
public:
  Filtered_triangle(const Vector& a, const Vector& b, const Vector& c, const Traits& traits)
      : m_a(a),
        m_b(b),
        m_c(c),
        m_u(b - a),
        m_v(c - a),
        m_normal(m_u.cross(m_v)),
        m_extent(m_u.cwiseAbs().cwiseMax(m_v.cwiseAbs())),
        m_size(m_normal.norm()),
        m_traits(traits)
  {}

  Box box() const { return Box(m_a).extend(m_b).extend(m_c); }

  // returns whether the corners lie on a line
  bool is_flat() const
  {
    // far above the rounding of the cross product
    if(m_normal.squaredNorm() > 1e-20 * m_u.squaredNorm() * m_v.squaredNorm()) return false;
    return predicates().are_collinear(point(m_a), point(m_b), point(m_c));
  }

  // returns whether the corner b lies strictly between the others. \pre the triangle is flat
  bool is_b_between() const
  {
    return predicates().is_strictly_between(point(m_a), point(m_b), point(m_c));
  }

  // returns whether the segment pq clearly stays farther than `distance` from the triangle's plane
  bool is_far_from_plane(const Vector& p, const Vector& q, double distance) const
  {
    const Vector v = p - m_a, w = q - m_a;
    const double side_p = m_normal.dot(v), side_q = m_normal.dot(w);
    if(!(side_p * side_q > 0)) return false;
    const auto [least, most] = std::minmax({std::abs(side_p), std::abs(side_q)});
    const Vector extent = m_extent.cwiseMax(v.cwiseAbs()).cwiseMax(w.cwiseAbs());
    return least > distance * m_size + bound(extent) && most <= largest;
  }

  // returns 1 or -1 if p is on that side of the plane for sure, otherwise 0
  int side(const Vector& p) const
  {
    const Vector w = p - m_a;
    return sign(m_normal.dot(w), m_extent.cwiseMax(w.cwiseAbs()));
  }

  // returns whether the closed segment pq meets the closed triangle
  bool meets(const Vector& p, const Vector& q) const
  {
    const int sides = side(p) * side(q);
    return sides <= 0 && meets_across(p, q, sides < 0);
  }

  // returns whether the closed segment from the corner a to s meets the triangle beyond a
  // \pre s differs from a
  bool meets_beyond_a(const Vector& s) const
  {
    return side(s) == 0 && meets_beyond_exactly(m_a, s, m_b, m_c);
  }

  // the same for the corner c
  bool meets_beyond_c(const Vector& s) const
  {
    return side(s) == 0 && meets_beyond_exactly(m_c, s, m_a, m_b);
  }

private:
  using Point_3 = typename Traits::Point_3;

  // Each of the six products of three differences carries at most nine roundings of 2^-53, that is,
  // the six together at most 6e-15 times the product of the largest differences; the rest is
  // margin.
  static constexpr double error_bound = 1e-14;
  static constexpr double min_extent = 1e-97; // products of two do not underflow

  // A determinant that is larger, or NaN, is uncertain: an intermediate result overflowed.
  static constexpr double largest = (std::numeric_limits<double>::max)();

  // the sign of a determinant, with the largest differences in x, y and z, or 0 if it is uncertain
  static int sign(double determinant, const Vector& extent)
  {
    const double size = std::abs(determinant);
    if(!(size > bound(extent) && size <= largest)) return 0;
    return determinant > 0 ? 1 : -1;
  }

  static double bound(const Vector& extent)
  {
    return extent.minCoeff() < min_extent ? std::numeric_limits<double>::infinity()
                                          : error_bound * (extent.x() * extent.y() * extent.z());
  }

  // For a line through p and q that crosses the plane: 1 if it meets the triangle, 0 if not, and -1
  // if that is uncertain.
  int meets_line(const Vector& p, const Vector& q) const
  {
    const Vector d = q - p, a = m_a - p, b = m_b - p, c = m_c - p;
    const Vector extent =
        d.cwiseAbs().cwiseMax(a.cwiseAbs()).cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs());
    const Vector db = d.cross(b);
    const int turn_ab = -sign(db.dot(a), extent), turn_bc = sign(db.dot(c), extent);
    if(turn_ab * turn_bc < 0) return 0;
    const int turn_ca = sign(d.cross(c).dot(a), extent);
    if(turn_ab * turn_ca < 0 || turn_bc * turn_ca < 0) return 0;
    return turn_ab != 0 && turn_bc != 0 && turn_ca != 0 ? 1 : -1;
  }

  Exact_predicates<Traits> predicates() const { return Exact_predicates<Traits>(m_traits); }
  Point_3 point(const Vector& p) const { return to_point(p, m_traits); }

  // where the ends are not clearly on one side of the plane, and clearly on two or not
  bool meets_across(const Vector& p, const Vector& q, bool does_cross) const
  {
    const int answer = does_cross ? meets_line(p, q) : -1;
    if(answer >= 0) return answer == 1;
    return predicates().does_segment_meet_triangle(point(p), point(q), point(m_a), point(m_b),
                                                   point(m_c));
  }

  bool meets_beyond_exactly(const Vector& corner,
                            const Vector& s,
                            const Vector& next,
                            const Vector& last) const
  {
    return predicates().does_segment_meet_triangle_beyond_corner(point(corner), point(s),
                                                                 point(next), point(last));
  }

  Vector m_a, m_b, m_c, m_u, m_v, m_normal, m_extent;
  double m_size;
  const Traits& m_traits;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_FILTERED_TRIANGLE_H
