// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_CLEARANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_CLEARANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <algorithm>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The clearance of a search, which must hand over a curve that can move: edges without a common
// node get no closer than a distance, unless they were closer, and corners get no sharper than 2
// degrees, unless they were sharper. Stricter than Clearance_rule, whose halves add up over
// millions of moves. In double arithmetic, and no part of any proof.
class Search_clearance
{
public:
  Search_clearance() = default;
  explicit Search_clearance(double distance) : m_distance(distance) {}

  double distance() const { return m_distance; }

  // whether the edge pq may be as close to the new edge ac as it is
  template <typename SquaredDistance>
  bool is_kept(const Vector& p,
               const Vector& q,
               const Vector& a,
               const Vector& c,
               const SquaredDistance& squared_before) const
  {
    if(!(m_distance > 0)) return true;
    const double after = squared_segment_distance(p, q, a, c);
    return after >= m_distance * m_distance || after >= squared_before();
  }

  // whether the corner abc is too sharp
  bool does_fold(const Vector& a, const Vector& b, const Vector& c) const
  {
    return m_distance > 0 && is_sharp(a, b, c);
  }

  // likewise, where the corner was at `before`
  bool does_fold(const Vector& a, const Vector& b, const Vector& c, const Vector& before) const
  {
    return does_fold(a, b, c) && cosine(a, b, c) > cosine(a, before, c);
  }

  // likewise, where the corner went on to `before` instead of c
  bool does_bend(const Vector& a, const Vector& b, const Vector& c, const Vector& before) const
  {
    return does_fold(a, b, c) && cosine(a, b, c) > cosine(a, b, before);
  }

private:
  static bool is_sharp(const Vector& a, const Vector& b, const Vector& c)
  {
    constexpr double least_tangent = 0.035; // of 2 degrees
    const Vector u = a - b, v = c - b;
    const double dot = u.dot(v), bound = least_tangent * dot;
    return dot > 0 && u.cross(v).squaredNorm() < bound * bound;
  }

  static double cosine(const Vector& a, const Vector& b, const Vector& c)
  {
    return (a - b).normalized().dot((c - b).normalized());
  }

  double m_distance = 0;
};

// The same for the triangle abc of a change, in the words of elementary_move.h: the edges
// ab, bc become one edge ac.
struct Clearance_of_shortcut
{
  const Search_clearance& rule;
  const Vector &a, &b, &c;

  double distance() const { return rule.distance(); }
  bool allows_at_a(const Vector& p) const { return !rule.does_bend(p, a, c, b); }
  bool allows_at_c(const Vector& p) const { return !rule.does_bend(p, c, a, b); }

  bool allows(const Vector& p, const Vector& q) const
  {
    return rule.is_kept(p, q, a, c, [&] {
      return (std::min)(squared_segment_distance(p, q, a, b), squared_segment_distance(p, q, b, c));
    });
  }
};

// The edge ac becomes two edges ab, bc.
struct Clearance_of_detour
{
  const Search_clearance& rule;
  const Vector &a, &b, &c;

  double distance() const { return rule.distance(); }
  bool allows_at_a(const Vector& p) const { return !rule.does_bend(p, a, b, c); }
  bool allows_at_c(const Vector& p) const { return !rule.does_bend(p, c, b, a); }

  bool allows(const Vector& p, const Vector& q) const
  {
    const auto before = [&] { return squared_segment_distance(p, q, a, c); };
    return rule.is_kept(p, q, a, b, before) && rule.is_kept(p, q, b, c, before);
  }
};

// The edge ab becomes ac, where c is no node yet.
struct Clearance_of_swing
{
  const Search_clearance& rule;
  const Vector &a, &b, &c;

  double distance() const { return rule.distance(); }
  bool allows_at_a(const Vector& p) const { return !rule.does_bend(p, a, c, b); }
  bool allows_at_c(const Vector&) const { return true; }

  bool allows(const Vector& p, const Vector& q) const
  {
    return rule.is_kept(p, q, a, c, [&] { return squared_segment_distance(p, q, a, b); });
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_CLEARANCE_H
