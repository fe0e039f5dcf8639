// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_STATIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_STATIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/filling/Well_spaced_points.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_list.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_neighborhoods.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Point that a curve passes through or is to reach.
struct Finger_station
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Vector position;
  double thickness;
  std::vector<std::size_t> edges; // of the curve, from which fingers can grow
  std::size_t component = none;

  bool is_reached() const { return component != none; }
};

// \throws std::invalid_argument if a component has no edge from which fingers can grow
template <typename Network>
void check_sliding(const Network& curves, const std::string& advice = "")
{
  for(std::size_t c = 0; c < curves.number_of_components(); ++c)
    if(slides_everywhere(curves, c))
      throw std::invalid_argument(
          "all nodes of component " + std::to_string(c) + ", from node " +
          std::to_string(curves.first_node(c)) +
          " on, slide or are pinned: fingers would leave the sets on which they slide" + advice);
}

// Stations of a tree of fingers: its roots, which are stretches of the curves; its targets, which
// are well-spaced points in the domain; and waypoints of the paths to targets that are hard to
// reach. Near-linear in their number.
template <typename Guard, typename Domain>
class Finger_stations
{
  using Network = typename Guard::Curve_network;
  using Point_3 = typename Guard::Point_3;

public:
  // Takes the distance between neighboring stations, in units of the thickness. Edges of the curves
  // longer than half of it are halved, by certified insertions, until the run is to stop.
  Finger_stations(Guard& guard,
                  const Domain& domain,
                  const Thickness<Point_3>& thickness,
                  double spacing,
                  Run_watch& watch)
      : m_guard(guard), m_domain(domain), m_thickness(thickness), m_spacing(spacing), m_watch(watch)
  {
    add_stretches_of_curves();
  }

  // Adds points of the domain, no more once the run is to stop.
  void add_targets(std::uint64_t seed)
  {
    std::vector<Vector> roots;
    for(const Finger_station& station : m_stations) roots.push_back(station.position);
    const auto distance = [this](const Point_3& p) { return m_spacing * m_thickness(p); };
    Well_spaced_points<Domain, typename Network::Traits, decltype(distance)> points(
        m_domain, distance, target_clearance / m_spacing, curve().traits(), m_watch,
        m_guard.boundary().layer());
    try {
      const Watched_scope scope(&m_watch);
      for(const Vector& p : points(roots, seed)) m_stations.push_back({p, thickness(p), {}});
    } catch(const Run_stopped&) {
    }
    m_number_of_targets = m_stations.size() - m_number_of_roots;
    m_neighborhoods = std::make_unique<Node_neighborhoods>(positions());
  }

  // Adds a waypoint, which within() does not find.
  std::size_t add_waypoint(const Vector& p)
  {
    m_stations.push_back({p, thickness(p), {}});
    return m_stations.size() - 1;
  }

  Finger_station& operator[](std::size_t s) { return m_stations[s]; }
  const Finger_station& operator[](std::size_t s) const { return m_stations[s]; }

  // Roots have the first indices, targets the next ones.
  std::size_t number_of_roots() const { return m_number_of_roots; }
  std::size_t number_of_targets() const { return m_number_of_targets; }

  bool is_root(std::size_t s) const { return s < m_number_of_roots; }
  bool is_target(std::size_t s) const
  {
    return !is_root(s) && s - m_number_of_roots < m_number_of_targets;
  }

  // the distance from a station to its neighbors
  double spacing(std::size_t s) const { return m_spacing * m_stations[s].thickness; }

  // The roots and targets within a distance of p, in the order of their indices. \pre the targets
  // have been added
  std::vector<std::size_t> within(double distance, const Vector& p)
  {
    m_neighborhoods->find(p, distance, m_near);
    m_near.keep_within(p, distance);
    std::vector<std::size_t> stations;
    for(std::size_t k = 0; k < m_near.size(); ++k) stations.push_back(m_near.index(k));
    std::sort(stations.begin(), stations.end());
    return stations;
  }

private:
  static constexpr double target_clearance =
      0.5; // in units of the thickness; halved twice where it is narrow

  const Network& curve() const { return m_guard.curve(); }

  double thickness(const Vector& p) const { return m_thickness(to_point(p, curve().traits())); }

  // Divides the edges of each component into stretches as long as the spacing of stations. Edges
  // whose inserted nodes slide are left out, since fingers would leave their sets, and so are other
  // edges between constrained nodes, unless a component has no others.
  void add_stretches_of_curves()
  {
    halve_long_edges();
    std::vector<bool> has_free_edge(curve().number_of_components(), false);
    for(std::size_t e = 0; e < curve().number_of_edges(); ++e)
      if(!is_constrained(e)) has_free_edge[component(e)] = true;
    std::vector<std::size_t> last(curve().number_of_components(), Finger_station::none);
    for(std::size_t e = 0; e < curve().number_of_edges(); ++e) {
      const std::size_t c = component(e);
      if(slides(e) || (is_constrained(e) && has_free_edge[c])) continue;
      const Vector a = to_vector(curve().point(curve().source(e)));
      const Vector b = to_vector(curve().point(curve().target(e)));
      const Vector middle = (a + b) / 2;
      const auto is_far = [&](const Finger_station& s) {
        return (s.position - middle).norm() > m_spacing * s.thickness;
      };
      if(last[c] == Finger_station::none || is_far(m_stations[last[c]])) {
        last[c] = m_stations.size();
        m_stations.push_back({middle, thickness(middle), {}, c});
      }
      m_stations[last[c]].edges.push_back(e);
    }
    m_number_of_roots = m_stations.size();
  }

  std::size_t component(std::size_t e) const { return curve().component(curve().source(e)); }

  bool slides(std::size_t e) const
  {
    return slides_between(curve(), curve().source(e), curve().target(e));
  }

  bool is_constrained(std::size_t e) const
  {
    return !curve().is_free(curve().source(e)) && !curve().is_free(curve().target(e));
  }

  // The halves of an edge keep its index and get a new last one.
  void halve_long_edges()
  {
    for(std::size_t e = 0; e < curve().number_of_edges(); ++e)
      while(is_long(e) && !m_watch.must_stop() && halve_edge(m_guard, e)) continue;
  }

  bool is_long(std::size_t e) const
  {
    const Vector a = to_vector(curve().point(curve().source(e)));
    const Vector b = to_vector(curve().point(curve().target(e)));
    return (b - a).norm() > m_spacing / 2 * thickness((a + b) / 2);
  }

  Vector_field positions() const
  {
    Vector_field x(static_cast<Eigen::Index>(m_stations.size()), 3);
    for(std::size_t s = 0; s < m_stations.size(); ++s) set_row(x, s, m_stations[s].position);
    return x;
  }

  Guard& m_guard;
  const Domain& m_domain;
  const Thickness<Point_3>& m_thickness;
  const double m_spacing; // in units of the thickness
  Run_watch& m_watch;
  std::vector<Finger_station> m_stations;
  std::size_t m_number_of_roots = 0, m_number_of_targets = 0;
  std::unique_ptr<Node_neighborhoods> m_neighborhoods; // of roots and targets
  Node_list m_near;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_STATIONS_H
