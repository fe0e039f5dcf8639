// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_CONNECTIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_CONNECTIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Direction_preference.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Field_vector.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Candidate connections of fingers, per component: pairs of a reached station and a nearby
// unreached one. Random weights make the tree bushy, and prefer a direction field if there is one.
template <typename Stations, typename Traits>
class Finger_connections
{
  using Point_3 = typename Traits::Point_3;

public:
  using Direction_field = std::function<Field_vector(const Point_3&)>;

  struct Connection
  {
    double weight;
    std::size_t from, to;

    bool operator<(const Connection& other) const
    {
      return std::tie(weight, from, to) > std::tie(other.weight, other.from, other.to);
    }
  };

  // How far connections reach, in units of the spacing of stations. Stations leave no gaps wider
  // than 1 around a point, hence 2 would join all neighbors; longer fingers are likelier to meet
  // others.
  static constexpr double reach = 1.7;

  Finger_connections(Stations& stations, Random_source& random, const Traits& traits)
      : m_stations(stations), m_random(random), m_traits(traits)
  {}

  // Takes a field, and by how much more length across it counts.
  void follow(const Direction_field& field, double detour)
  {
    m_direction_field = field;
    m_detour = detour;
  }

  // Adds the connections from a reached station.
  void add_from(std::size_t s)
  {
    const auto& station = m_stations[s];
    if(m_connections.size() <= station.component) m_connections.resize(station.component + 1);
    const double distance = m_stations.spacing(s);
    const Vector direction = direction_at(station.position);
    for(const std::size_t t : m_stations.within(reach * distance, station.position)) {
      if(m_stations[t].is_reached()) continue;
      const double length = effort(m_stations[t].position - station.position, direction);
      const double weight = length + randomness * distance * m_random.real();
      m_connections[station.component].push({weight, s, t});
    }
  }

  // Removes and returns the lightest connection of a component to an unreached station, if any.
  std::optional<Connection> take(std::size_t component)
  {
    if(component >= m_connections.size()) return std::nullopt;
    auto& connections = m_connections[component];
    while(!connections.empty()) {
      const Connection connection = connections.top();
      connections.pop();
      if(!m_stations[connection.to].is_reached()) return connection;
    }
    return std::nullopt;
  }

private:
  static constexpr double randomness = 0.6; // added to lengths, in units of the spacing

  Vector direction_at(const Vector& p) const
  {
    return m_direction_field ? unit_direction(m_direction_field, to_point(p, m_traits)) : Vector();
  }

  // The length of a connection, which counts more the less it goes along a unit vector, or zero.
  double effort(const Vector& v, const Vector& direction) const
  {
    const double length = v.norm();
    if(direction == Vector()) return length;
    const double along = v.dot(direction) / length;
    return length * (1 + m_detour * (1 - along * along));
  }

  Stations& m_stations;
  Random_source& m_random;
  const Traits m_traits;
  Direction_field m_direction_field; // null without a field
  double m_detour = 0;               // by how much more length across the field counts
  std::vector<std::priority_queue<Connection>> m_connections; // of each component, lightest first
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_CONNECTIONS_H
