// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FINGERS_WELL_SPACED_POINTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FINGERS_WELL_SPACED_POINTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_list.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_neighborhoods.h>
#include <CGAL/Volume_filling_curves/internal/support/Deadline.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Points inside a domain that keep a distance from one another, which may vary in space, and from
// the boundary, and leave little room for more. Dart throwing (Cook 1986) over a finite set: from
// candidates on a jittered grid, three to the distance along each axis, each that is left in random
// order is taken and strikes out those within its distance. Near linear in their number.
template <typename Domain, typename Traits, typename Distance>
class Well_spaced_points
{
  using Point_3 = typename Traits::Point_3;

public:
  // Takes the distance at a point, also to be kept from points that are there already, and what
  // part of it is to be kept from the boundary. After the deadline no more points are found.
  Well_spaced_points(const Domain& domain,
                     const Distance& distance,
                     double room,
                     const Traits& traits,
                     const Deadline& deadline)
      : m_domain(domain), m_distance(distance), m_room(room), m_traits(traits), m_deadline(deadline)
  {}

  std::vector<Vector> operator()(const std::vector<Vector>& there, std::size_t seed)
  {
    Random_source random(seed);
    find_candidates(random);
    const Node_neighborhoods neighborhoods(field_of(m_candidates));
    m_is_struck_out.assign(m_candidates.size(), false);
    for(const Vector& p : there) strike_out_near(p, neighborhoods);
    const std::vector<std::size_t> order = shuffled(m_candidates.size(), random);
    std::vector<Vector> points;
    for(const double room : {m_room, m_room / 2, m_room / 4}) // spikes come last
      for(const std::size_t k : order) {
        if(m_deadline.has_passed()) return points;
        if(m_is_struck_out[k] || !has_room(m_candidates[k], room)) continue;
        points.push_back(m_candidates[k]);
        strike_out_near(m_candidates[k], neighborhoods);
      }
    return points;
  }

private:
  static constexpr double candidates_along_distance = 3;
  static constexpr int most_halvings = 20; // of the box

  struct Cube
  {
    Vector low;
    double side;
  };

  // Cubes around the box are divided down to the size that is asked for there, but not outside.
  void find_candidates(Random_source& random)
  {
    const CGAL::Bbox_3 box = m_domain.bbox();
    const Vector low(box.xmin(), box.ymin(), box.zmin());
    const Vector sides(box.x_span(), box.y_span(), box.z_span());
    double side = size_of_cube(low + sides / 2);
    while(side < sides.maxCoeff()) side *= 2;
    m_least_side = side * std::ldexp(1, -most_halvings);
    divide({low, side}, random);
  }

  double size_of_cube(const Vector& p) const
  {
    return m_distance(to_point(p, m_traits)) / candidates_along_distance;
  }

  void divide(const Cube& cube, Random_source& random)
  {
    const double x = random.real(), y = random.real(), z = random.real();
    const Vector p = cube.low + cube.side * Vector(x, y, z);
    constexpr double slack = 1 + 1e-9;
    if(cube.side <= slack * size_of_cube(p) || cube.side <= m_least_side)
      m_candidates.push_back(p);
    else if(!is_outside(cube) && !m_deadline.has_passed())
      for(int k = 0; k < 8; ++k)
        divide({cube.low + cube.side / 2 * Vector(k % 2, k / 2 % 2, k / 4), cube.side / 2}, random);
  }

  bool is_outside(const Cube& cube) const
  {
    const Point_3 center = to_point(cube.low + cube.side / 2 * Vector::constant(1), m_traits);
    return !m_domain.is_inside(center) && m_domain.distance(center) > 0.87 * cube.side;
  }

  bool has_room(const Vector& x, double room) const
  {
    const Point_3 p = to_point(x, m_traits);
    return m_domain.is_inside(p) && m_domain.distance(p) >= room * m_distance(p);
  }

  static Vector_field field_of(const std::vector<Vector>& points)
  {
    Vector_field field(static_cast<Eigen::Index>(points.size()), 3);
    for(std::size_t k = 0; k < points.size(); ++k) set_row(field, k, points[k]);
    return field;
  }

  void strike_out_near(const Vector& p, const Node_neighborhoods& neighborhoods)
  {
    const double distance = m_distance(to_point(p, m_traits));
    neighborhoods.find(p, distance, m_near);
    m_near.keep_within(p, distance);
    for(std::size_t k = 0; k < m_near.size(); ++k) m_is_struck_out[m_near.index(k)] = true;
  }

  static std::vector<std::size_t> shuffled(std::size_t n, Random_source& random)
  {
    std::vector<std::size_t> order(n);
    for(std::size_t k = 0; k < n; ++k) {
      const std::size_t j = random.index(k + 1);
      order[k] = order[j];
      order[j] = k;
    }
    return order;
  }

  const Domain& m_domain;
  const Distance& m_distance;
  const double m_room; // at the boundary, in units of the distance
  const Traits m_traits;
  const Deadline& m_deadline;
  double m_least_side = 0;
  std::vector<Vector> m_candidates;
  std::vector<bool> m_is_struck_out;
  Node_list m_near;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FINGERS_WELL_SPACED_POINTS_H
