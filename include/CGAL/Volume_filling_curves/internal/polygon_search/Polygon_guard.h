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

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Clearance rule of the search, whose result must leave the flow space to move. Edges without a
// common node may not come closer than a given distance, nor corners become sharper than 2 degrees;
// those beyond these limits may not get worse. Clearance_rule lets distances halve, again and again
// over millions of moves. Plain double; no proof depends on it.
class Search_clearance
{
public:
  Search_clearance() = default;
  explicit Search_clearance(double distance) : m_distance(distance) {}

  double distance() const { return m_distance; }

  // Returns whether the new edge ac keeps the distance from edge pq.
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

  // Returns whether corner abc is too sharp.
  bool does_fold(const Vector& a, const Vector& b, const Vector& c) const
  {
    return m_distance > 0 && is_sharp(a, b, c);
  }

  // Returns whether corner abc is too sharp, and sharper than with its node at `before`.
  bool does_fold(const Vector& a, const Vector& b, const Vector& c, const Vector& before) const
  {
    return does_fold(a, b, c) && cosine(a, b, c) > cosine(a, before, c);
  }

  // Returns whether corner abc is too sharp, and sharper than with `before` in place of c.
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

// The rule for each kind of change, with the members that elementary_move.h calls.

// Edges ab and bc become one edge ac.
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

// Edge ac becomes two edges ab and bc.
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

// Edge ab becomes ac; c is not a node yet.
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

// Guard of a search's polygon. It carries out a change if and only if the change is an elementary
// move, by the criteria of Isotopy_guard_3, and keeps the clearance.
class Polygon_guard
{
  using Index = Search_polygon::Index;

public:
  Polygon_guard(Search_polygon& polygon, const Search_clearance& clearance)
      : m_polygon(polygon), m_clearance(clearance)
  {}

  // Each returns whether it made the change. \pre v is a free node, and so is one end of e

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

  // whether the edge from a to v can follow when v moves
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
