// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_GOAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_GOAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/knots/Link_triviality.h>
#include <CGAL/Volume_filling_curves/internal/knots/unknot_proof.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Search_polygon.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Goal of a search: all components are closed with at most 5 edges, hence unknots (Randell 1994),
// and several components form a trivial link. Constant time while some component has more edges.
class Search_goal
{
public:
  template <typename Network>
  explicit Search_goal(const Network& curve)
  {
    for(std::size_t c = 0; c < curve.number_of_components(); ++c)
      m_is_possible = m_is_possible && curve.is_closed(c);
  }

  static bool has_small_components(const Search_polygon& polygon)
  {
    const auto& edges = polygon.edges_of_component();
    return std::all_of(edges.begin(), edges.end(), [](auto n) { return n <= edges_of_unknots; });
  }

  // Remembers that components are linked, since no search can change that.
  bool operator()(const Search_polygon& polygon)
  {
    if(!m_is_possible || !has_small_components(polygon)) return false;
    const std::size_t n = polygon.edges_of_component().size();
    if(n == 1) return true;
    const Curve_network_3<> curve = network(polygon);
    const Link_status status = Link_triviality<Curve_network_3<>>(curve)(
        std::vector<Unknot_proof>(n, Unknot_proof::EDGES));
    m_is_possible = status != Link_status::LINKED;
    return status == Link_status::TRIVIAL;
  }

private:
  static Curve_network_3<> network(const Search_polygon& polygon)
  {
    std::vector<Curve_network_3<>::Point_3> points;
    std::vector<std::array<std::size_t, 2>> edges;
    for(std::size_t v = 0; v < polygon.number_of_nodes(); ++v)
      points.push_back(
          to_point(polygon.position(static_cast<std::uint32_t>(v)), Curve_flow_traits_3<>()));
    polygon.for_each_edge([&](auto e) { edges.push_back({polygon.source(e), polygon.target(e)}); });
    return Curve_network_3<>(points, edges);
  }

  bool m_is_possible = true;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_GOAL_H
