// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PORT_ARCS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PORT_ARCS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/filling/Neck_placement.h>
#include <CGAL/Volume_filling_curves/internal/filling/Path_search.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Arcs from which a filling between ports starts: one from each odd port to the next port. An arc
// begins and ends with a straight neck, whose nodes are pinned; a path through the domain, which
// keeps a distance from the boundary, joins the two.
template <typename Domain, typename Traits>
class Port_arcs
{
  using Point_3 = typename Traits::Point_3;
  using Paths = Path_search<Domain_without_segments<Domain>, Traits>;

public:
  using Polyline = std::vector<Point_3>;

  // Takes the distance between the nodes of a neck, in units of the thickness. Throws
  // std::invalid_argument, with the number of the port, from 1, if there is no neck or no path.
  Port_arcs(const Domain& domain,
            const Thickness<Point_3>& thickness,
            const std::vector<Port<Point_3>>& ports,
            double wall_distance,
            double spacing,
            const Traits& traits)
      : m_domain(domain),
        m_thickness(thickness),
        m_wall_distance(wall_distance),
        m_spacing(spacing),
        m_traits(traits)
  {
    if(ports.size() % 2 == 1)
      throw std::invalid_argument("ports: there are " + std::to_string(ports.size()) +
                                  ", but every arc needs two");
    for(std::size_t k = 0; k < ports.size(); ++k)
      m_necks.push_back(
          Neck_placement<Domain, Traits>(domain, m_thickness(ports[k].point), wall_distance,
                                         traits)(ports[k], "port " + std::to_string(k + 1)));
    require_disjoint_necks();
    require_connected_ports();
    for(std::size_t k = 0; k < ports.size(); k += 2) add_arc(k);
  }

  const std::vector<Polyline>& polylines() const { return m_polylines; }
  const std::vector<Port_neck<Point_3>>& necks() const { return m_necks; }

  // Returns the network of the paths, which is that of the arcs without the necks.
  Curve_network_3<Traits> paths() const
  {
    std::vector<Polyline> polylines;
    for(const std::vector<Vector>& path : m_paths) {
      polylines.emplace_back();
      for(const Vector& x : path) polylines.back().push_back(to_point(x, m_traits));
    }
    return Curve_network_3<Traits>(polylines, CGAL::parameters::default_values(), m_traits);
  }

  // Returns the network of the arcs, with the nodes of the necks pinned.
  Curve_network_3<Traits> network() const
  {
    Curve_network_3<Traits> network(m_polylines, CGAL::parameters::default_values(), m_traits);
    for(const std::size_t c : network.components()) {
      const std::size_t first = network.first_node(c), end = network.first_node(c + 1);
      for(std::size_t k = 0; k < nodes_of_neck(2 * c).size(); ++k) network.set_pinned(first + k);
      for(std::size_t k = 0; k < nodes_of_neck(2 * c + 1).size(); ++k)
        network.set_pinned(end - 1 - k);
    }
    return network;
  }

private:
  static constexpr double cell_sizes[] = {0.5, 0.25, 0.125, 0.0625}; // in units of the thickness
  static constexpr std::size_t max_cells = 2000000;                  // some seconds
  static constexpr double max_step = 2; // between nodes of a path, in units of the thickness

  double thickness_at(std::size_t k) const { return m_thickness(m_necks[k].end); }

  // the nodes of a neck, from the end of the curve on
  std::vector<Vector> nodes_of_neck(std::size_t k) const
  {
    const Port_neck<Point_3>& neck = m_necks[k];
    const Vector u(neck.direction[0], neck.direction[1], neck.direction[2]);
    const Vector end = to_vector(neck.end), inner = to_vector(neck.wall) + neck.length * u;
    const double number =
        (std::max)(1., std::ceil((inner - end).norm() / (m_spacing * thickness_at(k))));
    std::vector<Vector> nodes;
    for(double i = 0; i <= number; ++i) nodes.push_back(end + i / number * (inner - end));
    return nodes;
  }

  void require_disjoint_necks() const
  {
    const Exact_predicates<Traits> predicates(m_traits);
    const auto inner = [&](std::size_t k) { return to_point(nodes_of_neck(k).back(), m_traits); };
    for(std::size_t k = 0; k < m_necks.size(); ++k)
      for(std::size_t l = 0; l < k; ++l)
        if(predicates.do_segments_intersect(m_necks[k].wall, inner(k), m_necks[l].wall, inner(l)))
          throw std::invalid_argument("ports " + std::to_string(l + 1) + " and " +
                                      std::to_string(k + 1) + ": their necks meet");
  }

  // A domain with a surface knows its parts; in others no path will be found.
  void require_connected_ports() const
  {
    if constexpr(Has_surface<Domain>::value) {
      if(!has_surface(m_domain)) return;
      for(std::size_t k = 0; k < m_necks.size(); k += 2)
        if(m_domain.part(m_necks[k].end) != m_domain.part(m_necks[k + 1].end))
          throw std::invalid_argument(ports_from(k) + "they lie in different parts of the inside");
    }
  }

  // "ports K and K + 1: ", from 1
  static std::string ports_from(std::size_t k)
  {
    return "ports " + std::to_string(k + 1) + " and " + std::to_string(k + 2) + ": ";
  }

  // The domain for the path of an arc, without earlier paths and without necks; of its own two
  // necks the inner halves remain.
  Domain_without_segments<Domain> free_domain(std::size_t first) const
  {
    Domain_without_segments<Domain> domain(m_domain, m_wall_distance);
    for(const std::vector<Vector>& path : m_paths) domain.remove(path);
    for(std::size_t k = 0; k < m_necks.size(); ++k) {
      const std::vector<Vector> nodes = nodes_of_neck(k);
      const bool is_own = k == first || k == first + 1;
      domain.remove(to_vector(m_necks[k].wall),
                    is_own ? Vector((nodes.front() + nodes.back()) / 2) : nodes.back());
    }
    return domain;
  }

  void add_arc(std::size_t k)
  {
    const std::vector<Vector> from = nodes_of_neck(k), to = nodes_of_neck(k + 1);
    std::vector<Vector> nodes = from, inner = path(k, from.back(), to.back());
    // fingers need an edge with a free node, and would otherwise grow from the necks
    if(inner.size() == 1) nodes.push_back((from.back() + to.back()) / 2);
    nodes.insert(nodes.end(), inner.begin(), inner.end());
    m_paths.push_back({nodes.begin() + static_cast<std::ptrdiff_t>(from.size()) - 1, nodes.end()});
    nodes.insert(nodes.end(), to.rbegin() + 1, to.rend());
    Polyline polyline;
    for(const Vector& x : nodes) polyline.push_back(to_point(x, m_traits));
    m_polylines.push_back(polyline);
  }

  // Returns the nodes between the ends of two necks, with the second end.
  std::vector<Vector> path(std::size_t k, const Vector& from, const Vector& to) const
  {
    const Domain_without_segments<Domain> domain = free_domain(k);
    Paths paths(domain, m_traits, max_cells);
    const auto is_end = [&](const Vector& p) {
      check_run();
      return paths.sees(from, p);
    };
    const double step = max_step * thickness_at(k);
    for(const double cell : cell_sizes)
      if(paths.search(to, cell * thickness_at(k + 1), is_end))
        return divided(from, paths.path_from(from, step), step);
    throw std::invalid_argument(ports_from(k) + "no path was found between them");
  }

  // Divides the edges of a path into equal parts that are no longer than the step. A guard that
  // keeps a distance from the boundary decides by 1/64 of the size of a triangle: an edge of 21 r,
  // which came within 0.1 r of that distance, could not be divided, and the curve around it grew
  // without end.
  static std::vector<Vector> divided(Vector from, const std::vector<Vector>& path, double step)
  {
    std::vector<Vector> nodes;
    for(const Vector& to : path) {
      const double parts = std::ceil((to - from).norm() / step);
      for(double i = 1; i < parts; ++i) nodes.push_back(from + i / parts * (to - from));
      nodes.push_back(from = to);
    }
    return nodes;
  }

  const Domain& m_domain;
  const Thickness<Point_3> m_thickness;
  const double m_wall_distance, m_spacing;
  const Traits m_traits;
  std::vector<Port_neck<Point_3>> m_necks;
  std::vector<std::vector<Vector>> m_paths; // with the inner ends of the necks
  std::vector<Polyline> m_polylines;
};

// Marks the necks that are free: no edge meets the segment from the boundary to the end of the
// curve, except in this end. \pre the end of each neck is an end of the curve
template <typename Network>
void check_necks(const Network& curve, std::vector<Port_neck<typename Network::Point_3>>& necks)
{
  const Exact_predicates<typename Network::Traits> predicates(curve.traits());
  for(auto& neck : necks) {
    neck.is_free = true;
    for(const std::size_t e : curve.edges()) {
      auto p = curve.point(curve.source(e)), q = curve.point(curve.target(e));
      if(predicates.are_equal(q, neck.end)) std::swap(p, q);
      if(predicates.are_equal(p, neck.end)
             ? predicates.have_same_direction(p, q, neck.wall)
             : predicates.do_segments_intersect(p, q, neck.wall, neck.end))
        neck.is_free = false;
    }
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_PORT_ARCS_H
