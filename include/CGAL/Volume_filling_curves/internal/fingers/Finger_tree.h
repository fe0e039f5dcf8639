// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FINGERS_FINGER_TREE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FINGERS_FINGER_TREE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/fingers/Finger.h>
#include <CGAL/Volume_filling_curves/internal/fingers/Well_spaced_points.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/unit_direction.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_list.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_neighborhoods.h>
#include <CGAL/Volume_filling_curves/internal/support/Deadline.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Lets curves reach out all over a domain before they flow: fingers follow a random spanning tree
// of well-spaced points, which starts from all places of the curves (Prim's algorithm). What comes
// out is the outline of a tree where a small circle was, isotopic to it, at a cost that is
// proportional to the number of points. Of several components the one that has got least of the
// volume goes on first.
template <typename Guard, typename Domain, typename Thickness>
class Finger_tree
{
  using Network = typename Guard::Curve_network;
  using Point_3 = typename Guard::Point_3;

public:
  // Takes the thickness at a point. After the deadline nothing grows any more.
  Finger_tree(Guard& guard,
              const Domain& domain,
              const Thickness& thickness,
              std::size_t seed,
              const Deadline& deadline)
      : m_guard(guard),
        m_domain(domain),
        m_thickness(thickness),
        m_deadline(deadline),
        m_random(seed)
  {}

  using Direction_field = std::function<std::array<double, 3>(const Point_3&)>;

  // Lets the tree prefer connections along a field, if there is one and the weight is not 0.
  void follow(const Direction_field& field, double weight)
  {
    if(!field || !(weight > 0)) return;
    m_direction_field = field;
    m_detour = detour_over_weight * weight;
    m_spacing = spacing_along_field;
  }

  // Grows all fingers, and numbers the curves again.
  void grow()
  {
    add_stations_of_curves();
    add_stations_of_domain();
    m_neighborhoods = std::make_unique<Node_neighborhoods>(positions());
    for(std::size_t s = 0; s < m_number_of_roots; ++s) reach(s, m_stations[s].component);
    for(std::size_t c = 0; c < m_volumes.size(); ++c) m_hungry.push({m_volumes[c], c});
    while(!m_hungry.empty() && !m_deadline.has_passed()) feed_hungriest();
    m_guard.collect_garbage();
  }

  // of the places in the domain, those that the curves have been through from the start left out
  std::size_t number_of_places() const { return m_stations.size() - m_number_of_roots; }
  std::size_t number_of_fingers() const { return m_number_of_reached - m_number_of_roots; }

private:
  // In units of the thickness; distances to the boundary are halved twice where it is narrow.
  static constexpr double spacing = 2.9; // of the stations: a finger is two strands
  // Strands side by side leave longer gaps: with 2.9 the bunny ends with p99 1.43 (2026-11-22).
  static constexpr double spacing_along_field = 2.65;
  static constexpr double room_of_station = 0.5;
  static constexpr double half_widths[] = {0.7, 0.21, 0.1}; // of tips, the first that has room
  static constexpr double room_of_tip = 0.2;
  // In units of the spacing.
  static constexpr double reach_of_station = 1.7;
  static constexpr double randomness = 0.6; // that is added to lengths, so that the tree is bushy

  static constexpr double detour_over_weight = 20; // see m_detour; twice that changes little

  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  // A place that the curve goes through, or is to reach.
  struct Station
  {
    Vector position;
    double thickness;
    std::vector<std::size_t> edges; // of the curve, that fingers can grow out of
    std::size_t component = nowhere;
  };

  struct Connection
  {
    double weight;
    std::size_t from, to;

    bool operator<(const Connection& other) const
    {
      return std::tie(weight, from, to) > std::tie(other.weight, other.from, other.to);
    }
  };

  const Network& curve() const { return m_guard.curve(); }

  double thickness(const Vector& p) const { return m_thickness(to_point(p, curve().traits())); }

  // The edges of each component, in stretches as long as stations are apart.
  void add_stations_of_curves()
  {
    halve_long_edges();
    std::vector<std::size_t> last(curve().number_of_components(), nowhere);
    for(std::size_t e = 0; e < curve().number_of_edges(); ++e) {
      const std::size_t c = curve().component(curve().source(e));
      const Vector a = to_vector(curve().point(curve().source(e)));
      const Vector b = to_vector(curve().point(curve().target(e)));
      const Vector middle = (a + b) / 2;
      const auto is_far = [&](const Station& s) {
        return (s.position - middle).norm() > m_spacing * s.thickness;
      };
      if(last[c] == nowhere || is_far(m_stations[last[c]])) {
        last[c] = m_stations.size();
        m_stations.push_back({middle, thickness(middle), {}, c});
      }
      m_stations[last[c]].edges.push_back(e);
    }
    m_number_of_roots = m_stations.size();
    m_connections.resize(last.size());
    m_volumes.resize(last.size(), 0);
  }

  // The halves of an edge keep its index and get a new last one.
  void halve_long_edges()
  {
    for(std::size_t e = 0; e < curve().number_of_edges(); ++e)
      while(is_long(e) && halve_edge(m_guard, e)) continue;
  }

  bool is_long(std::size_t e) const
  {
    const Vector a = to_vector(curve().point(curve().source(e)));
    const Vector b = to_vector(curve().point(curve().target(e)));
    return (b - a).norm() > m_spacing / 2 * thickness((a + b) / 2);
  }

  void add_stations_of_domain()
  {
    std::vector<Vector> there;
    for(const Station& station : m_stations) there.push_back(station.position);
    const auto distance = [this](const Point_3& p) { return m_spacing * m_thickness(p); };
    Well_spaced_points<Domain, typename Network::Traits, decltype(distance)> points(
        m_domain, distance, room_of_station / m_spacing, curve().traits(), m_deadline);
    for(const Vector& p : points(there, m_random.bits()))
      m_stations.push_back({p, thickness(p), {}, nowhere});
  }

  Vector_field positions() const
  {
    Vector_field x(static_cast<Eigen::Index>(m_stations.size()), 3);
    for(std::size_t s = 0; s < m_stations.size(); ++s) set_row(x, s, m_stations[s].position);
    return x;
  }

  // Takes note that a component has got to a station, and of where it can go from there.
  void reach(std::size_t s, std::size_t component)
  {
    Station& station = m_stations[s];
    station.component = component;
    ++m_number_of_reached;
    const double distance = m_spacing * station.thickness;
    const Vector direction = direction_at(station.position);
    m_volumes[component] += distance * distance * distance;
    for(const std::size_t t : stations_near(station.position, reach_of_station * distance)) {
      if(m_stations[t].component != nowhere) continue;
      const double length = effort(m_stations[t].position - station.position, direction);
      const double weight = length + randomness * distance * m_random.real();
      m_connections[component].push({weight, s, t});
    }
  }

  Vector direction_at(const Vector& p) const
  {
    return m_direction_field ? unit_direction(m_direction_field, to_point(p, curve().traits()))
                             : Vector();
  }

  // The length of a connection, which counts more the less it goes along a unit vector, or zero.
  double effort(const Vector& v, const Vector& direction) const
  {
    const double length = v.norm();
    if(direction == Vector()) return length;
    const double along = v.dot(direction) / length;
    return length * (1 + m_detour * (1 - along * along));
  }

  std::vector<std::size_t> stations_near(const Vector& p, double distance)
  {
    m_neighborhoods->find(p, distance, m_near);
    m_near.keep_within(p, distance);
    std::vector<std::size_t> near;
    for(std::size_t k = 0; k < m_near.size(); ++k) near.push_back(m_near.index(k));
    std::sort(near.begin(), near.end());
    return near;
  }

  // Lets the component that has the least volume grow by a finger.
  void feed_hungriest()
  {
    const std::size_t component = m_hungry.top().second;
    m_hungry.pop();
    auto& connections = m_connections[component];
    while(!connections.empty()) {
      const Connection connection = connections.top();
      connections.pop();
      if(m_stations[connection.to].component != nowhere || !reach_out(connection)) continue;
      reach(connection.to, component);
      return m_hungry.push({m_volumes[component], component});
    }
  }

  // Tries the edges of a station, those that are placed best first.
  bool reach_out(const Connection& connection)
  {
    std::vector<std::pair<double, std::size_t>> edges;
    for(const std::size_t e : m_stations[connection.from].edges)
      edges.push_back({Finger<Guard>::span(curve(), e, m_stations[connection.to].position), e});
    std::sort(edges.begin(), edges.end(), std::greater<>());
    return std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
      return edge.first > 0 && grow_out_of(edge.second, connection);
    });
  }

  bool grow_out_of(std::size_t e, const Connection& connection)
  {
    Station& to = m_stations[connection.to];
    const double free = distance_to_boundary(to.position);
    const auto has_room = [&](const Vector& x) {
      return distance_to_boundary(x) >= (std::min)(room_of_tip * to.thickness, free / 4);
    };
    Finger<Guard> finger(m_guard, e);
    for(const double half_width : half_widths)
      if(finger.grow(to.position, (std::min)(half_width * to.thickness, free / 2), has_room)) {
        to.edges.push_back(finger.tip());
        return true;
      }
    finger.withdraw();
    return false;
  }

  // 0 outside
  double distance_to_boundary(const Vector& x) const
  {
    const Point_3 p = to_point(x, curve().traits());
    return m_domain.is_inside(p) ? m_domain.distance(p) : 0;
  }

  Guard& m_guard;
  const Domain& m_domain;
  const Thickness& m_thickness;
  const Deadline& m_deadline;
  Random_source m_random;
  Direction_field m_direction_field; // none if the tree is to follow no directions
  double m_detour = 0;               // by how much more length across the field counts
  double m_spacing = spacing;
  std::vector<Station> m_stations; // those of the curves first
  std::size_t m_number_of_roots = 0, m_number_of_reached = 0;
  std::unique_ptr<Node_neighborhoods> m_neighborhoods; // of the stations
  Node_list m_near;

  // of each component
  std::vector<std::priority_queue<Connection>> m_connections; // to where it may go, lightest first
  std::vector<double> m_volumes;                              // it has got

  using Hunger = std::pair<double, std::size_t>; // a component's volume, and the component
  std::priority_queue<Hunger, std::vector<Hunger>, std::greater<Hunger>> m_hungry;
};

template <typename Guard, typename Domain, typename Thickness>
Finger_tree<Guard, Domain, Thickness> finger_tree(Guard& guard,
                                                  const Domain& domain,
                                                  const Thickness& thickness,
                                                  std::size_t seed,
                                                  const Deadline& deadline)
{
  return {guard, domain, thickness, seed, deadline};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FINGERS_FINGER_TREE_H
