// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_GUARD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_GUARD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/guard/elementary_move.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Search_clearance.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Search_polygon.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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
