// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_WIDEST_BALL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_WIDEST_BALL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for the point of a set inside a domain that is farthest from the boundary. Distances are
// known up to a limit; points beyond it are visited along a space-filling curve, and most are
// skipped, since the distance cannot grow faster than the point moves. On the bunny, 400 of 14,000
// such samples are queried.
template <typename Domain>
class Deepest_point
{
  using Point_3 = typename Domain::Point_3;

public:
  // \pre there is a point; if a distance reaches the limit, the domain's are exact
  Deepest_point(const Domain& domain,
                const std::vector<Point_3>& points,
                const std::vector<double>& distances,
                double limit)
      : m_domain(domain), m_points(points)
  {
    const auto max = std::max_element(distances.begin(), distances.end());
    m_number = static_cast<std::size_t>(max - distances.begin());
    m_distance = *max;
    if(m_distance < limit) return;
    m_distance = domain.distance(points[m_number]);
    search(along_curve(distances, limit));
  }

  // the first one, if there are several
  std::size_t number() const { return m_number; }

  double distance() const { return m_distance; }

private:
  static constexpr double slack = 1 + 1e-9; // for the rounding of distances

  // the points whose distances reach the limit, in the order of a Hilbert curve
  std::vector<std::size_t> along_curve(const std::vector<double>& distances, double limit) const
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_3> positions;
    std::vector<std::size_t> order;
    for(std::size_t k = 0; k < m_points.size(); ++k) {
      const Vector x = to_vector(m_points[k]);
      positions.emplace_back(x.x(), x.y(), x.z());
      if(distances[k] >= limit) order.push_back(k);
    }
    const auto point_map = CGAL::make_property_map(positions);
    CGAL::hilbert_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(point_map)>(point_map));
    return order;
  }

  void search(const std::vector<std::size_t>& order)
  {
    std::size_t last = m_number; // the last point whose distance is known
    double distance = m_distance;
    for(const std::size_t k : order) {
      const double step = (to_vector(m_points[k]) - to_vector(m_points[last])).norm();
      if(slack * (distance + step) < m_distance) continue;
      last = k;
      distance = m_domain.distance(m_points[k]);
      if(distance < m_distance || (distance == m_distance && k > m_number)) continue;
      m_number = k;
      m_distance = distance;
    }
  }

  const Domain& m_domain;
  const std::vector<Point_3>& m_points;
  std::size_t m_number;
  double m_distance;
};

// Widest ball inside a domain that a local search finds: its center is the sample farthest from the
// boundary, improved along the axes with steps that are halved when none helps. The radius is
// accurate to a hundredth.
template <typename Domain, typename Traits>
class Widest_ball
{
  using Point_3 = typename Traits::Point_3;

public:
  // The middles of the edges of this polygon are 1 % nearer to the center than its nodes.
  static constexpr std::size_t nodes_of_round_circle = 24;

  // Takes the distances of the samples to the boundary, up to a limit. \pre there is a sample
  Widest_ball(const Domain& domain,
              const std::vector<Point_3>& samples,
              const std::vector<double>& distances,
              double limit,
              const Traits& traits)
      : m_domain(&domain), m_traits(traits)
  {
    const Deepest_point<Domain> deepest(domain, samples, distances, limit);
    m_center = to_vector(samples[deepest.number()]);
    m_radius = deepest.distance();
    ascend();
  }

  const Vector& center() const { return m_center; }
  double radius() const { return m_radius; }

  // A circle around the center of at most that radius, as a polyline whose last point repeats the
  // first.
  std::vector<Point_3> circle(double max_radius, std::size_t nodes = nodes_of_round_circle) const
  {
    const double radius = (std::min)(max_radius, radius_of_circle * m_radius);
    std::vector<Point_3> points;
    for(std::size_t k = 0; k < nodes; ++k) {
      const auto [cosine, sine] = cos_sin(static_cast<double>(k) / static_cast<double>(nodes));
      points.push_back(to_point(Vector(m_center + radius * Vector(cosine, sine, 0)), m_traits));
    }
    points.push_back(points.front());
    return points;
  }

private:
  static constexpr double radius_of_circle = 0.5;             // at most, in units of the ball's
  static constexpr double first_step = 0.5, last_step = 0.01; // in units of the radius

  static constexpr int max_steps = 10000; // ends the search in a domain of infinite depth

  bool try_center(const Vector& x)
  {
    const Point_3 p = to_point(x, m_traits);
    if(!m_domain->is_inside(p)) return false;
    const double distance = m_domain->distance(p);
    if(!(distance > m_radius)) return false;
    m_radius = distance;
    m_center = x;
    return true;
  }

  void ascend()
  {
    double step = first_step;
    for(int k = 0; k < max_steps && step > last_step; ++k)
      if(!try_neighbors(step * m_radius)) step /= 2;
  }

  bool try_neighbors(double step)
  {
    const Vector x = m_center;
    for(const Vector& axis : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)})
      if(try_center(x + step * axis) || try_center(x - step * axis)) return true;
    return false;
  }

  const Domain* m_domain;
  Traits m_traits;
  Vector m_center;
  double m_radius;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_WIDEST_BALL_H
