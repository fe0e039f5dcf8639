// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_NECK_PLACEMENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_NECK_PLACEMENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Position and direction of the straight part of a curve at a port, along the inward normal or a
// given direction. Domains have no normals, but distances: the normal leads from the port to the
// nearby point that is farthest from the boundary.
template <typename Domain, typename Traits>
class Neck_placement
{
  using Point_3 = typename Traits::Point_3;
  using Neck = Port_neck<Point_3>;

public:
  // Takes the thickness at the port, and the distance from the boundary that necks lead through.
  Neck_placement(const Domain& domain, double thickness, double wall_distance, const Traits& traits)
      : m_domain(domain), m_thickness(thickness), m_wall_distance(wall_distance), m_traits(traits)
  {}

  // Throws std::invalid_argument with the name of the port if there is no neck.
  Neck operator()(const Port<Point_3>& port, const std::string& name) const
  {
    const Vector p = to_vector(port.point);
    Vector given(port.direction[0], port.direction[1], port.direction[2]);
    if(!p.allFinite() || !given.allFinite())
      throw std::invalid_argument(name + " has a coordinate that is not finite");
    given = in_own_units(given).normalized();
    const Start start = find_start(p, given, name);
    return neck_from(start, name);
  }

private:
  // In units of the thickness.
  static constexpr double length = 1; // of a neck, where the domain is wide enough
  static constexpr double length_beyond_wall_distance = 0.5; // likewise
  static constexpr double end_gap = 1. / 64; // from the boundary to the end of the curve
  static constexpr double first_step = 1. / 16, last_step = 1; // from a port, to find the inside
  // A neck takes at most this share of the line across the domain.
  static constexpr double max_share_of_line = 0.5;
  static constexpr double first_turn = 0.5, last_turn = 1e-6; // of the search for the normal

  // A point inside, and the direction that leads there from the port.
  struct Start
  {
    Vector position, direction;
    double step;
  };

  double depth_at(const Vector& x) const { return depth(m_domain, to_point(x, m_traits)); }

  // A port that lies outside, by no more than the last step, is left by longer ones.
  Start find_start(const Vector& p, const Vector& given, const std::string& name) const
  {
    for(double step = first_step; step <= last_step; step *= 2) {
      const double s = step * m_thickness;
      const Vector u = given.norm() > 0 ? given : normal(p, s);
      if(depth_at(p + s * u) > 0) return {p + s * u, u, s};
    }
    throw std::invalid_argument(name + " is not at the boundary: nothing within the thickness, " +
                                "in its direction, is inside");
  }

  Vector normal(const Vector& p, double step) const
  {
    Vector best(0, 0, 1);
    double farthest = -1;
    const auto try_direction = [&](const Vector& u) {
      const double d = depth_at(p + step * u);
      if(!(d > farthest)) return false;
      farthest = d;
      best = u;
      return true;
    };
    for(int k = 0; k < 27; ++k)
      if(k != 13) try_direction(Vector(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1).normalized());
    for(double turn = first_turn; turn > last_turn;) {
      const Vector across = best.unitOrthogonal(), other = best.cross(across);
      const Vector u = best;
      const bool has_turned = try_direction((u + turn * across).normalized()) ||
                              try_direction((u - turn * across).normalized()) ||
                              try_direction((u + turn * other).normalized()) ||
                              try_direction((u - turn * other).normalized());
      if(!has_turned) turn /= 2;
    }
    return best;
  }

  // the distance to the boundary along u, or the limit
  double distance_to_boundary(const Vector& from, const Vector& u, double limit) const
  {
    using Vector_3 = typename Domain::Vector_3;
    return m_domain.distance_along(to_point(from, m_traits), Vector_3(u.x(), u.y(), u.z()), limit);
  }

  Neck neck_from(const Start& start, const std::string& name) const
  {
    const Vector& u = start.direction;
    const double limit = start.step + m_thickness;
    const double back = distance_to_boundary(start.position, -u, limit);
    if(!(back < limit))
      throw std::invalid_argument(name + " is not at the boundary, but farther than the thickness "
                                         "inside");
    const Vector wall = start.position - back * u, end = wall + end_gap * m_thickness * u;
    const double max_length = (std::max)(
        length * m_thickness, m_wall_distance + length_beyond_wall_distance * m_thickness);
    const double free =
        depth_at(end) > 0 ? distance_to_boundary(end, u, max_length / max_share_of_line) : 0;
    const double neck_length = (std::min)(max_length, max_share_of_line * free);
    if(!(neck_length > 2 * end_gap * m_thickness))
      throw std::invalid_argument(name + " has no room for a neck: the domain is too thin there");
    if(!(depth_at(wall + neck_length * u) > m_wall_distance))
      throw std::invalid_argument(name + " has no room for a neck that is longer than the wall "
                                         "distance");
    Neck neck;
    neck.wall = to_point(wall, m_traits);
    neck.end = to_point(end, m_traits);
    neck.direction = {u.x(), u.y(), u.z()};
    neck.length = neck_length;
    return neck;
  }

  const Domain& m_domain;
  const double m_thickness, m_wall_distance;
  const Traits m_traits;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_NECK_PLACEMENT_H
