// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_WIDEST_BALL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_WIDEST_BALL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/Deepest_point.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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
