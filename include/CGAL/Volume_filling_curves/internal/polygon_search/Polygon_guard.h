// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_GUARD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_GUARD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/guard/elementary_move.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Search_polygon.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Clearance rule of the search, which must pass on a curve that can move: edges without a common
// node get no closer than a given distance, and corners no sharper than 2 degrees, unless they
// already were. Stricter than Clearance_rule, whose repeated halving would add up over millions of
// moves. In double arithmetic, and not part of any proof.
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

  // Returns whether the corner abc is too sharp.
  bool does_fold(const Vector& a, const Vector& b, const Vector& c) const
  {
    return m_distance > 0 && is_sharp(a, b, c);
  }

  // The same, if the corner was at `before`.
  bool does_fold(const Vector& a, const Vector& b, const Vector& c, const Vector& before) const
  {
    return does_fold(a, b, c) && cosine(a, b, c) > cosine(a, before, c);
  }

  // The same, if the corner continued to `before` instead of c.
  bool does_bend(const Vector& a, const Vector& b, const Vector& c, const Vector& before) const
  {
    return does_fold(a, b, c) && cosine(a, b, c) > cosine(a, b, before);
  }

private:
  static bool is_sharp(const Vector& a, const Vector& b, const Vector& c)
  {
    constexpr double min_tangent = 0.035; // of 2 degrees
    const Vector u = a - b, v = c - b;
    const double dot = u.dot(v), bound = min_tangent * dot;
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

// The guard of a search's polygon, as Isotopy_guard_3 is that of a network: each change is carried
// out if and only if it is an elementary move, by the same criteria, and keeps the clearance.
class Polygon_guard
{
  using Index = Search_polygon::Index;

public:
  Polygon_guard(Search_polygon& polygon, const Search_clearance& clearance)
      : m_polygon(polygon), m_clearance(clearance)
  {}

  // Each returns whether it did. \pre v is a free node, and so is one end of e

  bool move_node(Index v, const Vector& target)
  {
    const Index a = m_polygon.neighbor(v, 0), c = m_polygon.neighbor(v, 1);
    const Vector &x = position(a), &y = position(v), &z = position(c);
    if(target == y || !passes_between(x, z, y, target, m_traits)) return false;
    if(!can_swing(a, v, target) || !can_swing(c, v, target)) return false;
    if(m_clearance.does_fold(x, target, z, y)) return false;
    m_polygon.move_node(v, target);
    return true;
  }

  bool remove_node(Index v)
  {
    const Index a = m_polygon.neighbor(v, 0), c = m_polygon.neighbor(v, 1);
    const Vector &x = position(a), &y = position(v), &z = position(c);
    if(!can_exchange_sides(m_polygon, a, c, Triangle(x, y, z, m_traits), is_at(v),
                           Clearance_of_shortcut{m_clearance, x, y, z}))
      return false;
    m_polygon.remove_node(v);
    return true;
  }

  bool insert_node(Index e, const Vector& y)
  {
    const Index a = m_polygon.source(e), c = m_polygon.target(e);
    const Vector &x = position(a), &z = position(c);
    const auto is_e = [e](Index f) { return f == e; };
    if(!can_exchange_sides(m_polygon, a, c, Triangle(x, y, z, m_traits), is_e,
                           Clearance_of_detour{m_clearance, x, y, z}))
      return false;
    if(m_clearance.does_fold(x, y, z)) return false;
    m_polygon.insert_node(e, y);
    return true;
  }

private:
  using Traits = Curve_flow_traits_3<>;
  using Triangle = Filtered_triangle<Traits>;

  const Vector& position(Index v) const { return m_polygon.position(v); }

  struct Is_at_node
  {
    Index first, second; // the node's edges
    bool operator()(Index e) const { return e == first || e == second; }
  };

  Is_at_node is_at(Index v) const { return {m_polygon.edge(v, 0), m_polygon.edge(v, 1)}; }

  // whether the edge from a to v may follow when v moves
  bool can_swing(Index a, Index v, const Vector& target) const
  {
    return is_triangle_free(m_polygon, a, Search_polygon::null,
                            Triangle(position(a), position(v), target, m_traits), is_at(v),
                            Clearance_of_swing{m_clearance, position(a), position(v), target});
  }

  Search_polygon& m_polygon;
  const Search_clearance& m_clearance;
  Traits m_traits;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_GUARD_H
