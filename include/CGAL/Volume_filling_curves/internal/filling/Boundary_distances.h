// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Distances from points inside a domain to its boundary. They are measured up to a limit, which
// suffices for most points and takes a fifth of the time on the bunny; beyond the limit the domain
// is queried again. Once the run is to stop, all distances but the first are left at 0. Throws
// std::invalid_argument if one is negative or not finite.
template <typename Domain>
class Boundary_distances
{
  using Point_3 = typename Domain::Point_3;

public:
  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  // The domain and the points must outlive the distances.
  template <typename ConcurrencyTag = Sequential_tag>
  Boundary_distances(const Domain& domain,
                     const std::vector<Point_3>& points,
                     double limit = no_limit,
                     Run_watch* watch = nullptr,
                     ConcurrencyTag = {})
      : m_domain(domain), m_points(points), m_limit(limit), m_distances(points.size(), 0)
  {
    constexpr std::size_t block = 256;
    for_each_block<ConcurrencyTag>(points.size(), block, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        if(k == 0 || !watch || !watch->must_stop())
          m_distances[k] = checked(depth_up_to(domain, points[k], limit), points[k]);
    });
  }

  // of the k-th point
  double operator[](std::size_t k) const
  {
    return m_distances[k] < m_limit ? m_distances[k]
                                    : checked(m_domain.distance(m_points[k]), m_points[k]);
  }

  // of all points; those that reach the limit may be larger
  const std::vector<double>& up_to_limit() const { return m_distances; }

  double limit() const { return m_limit; }

private:
  static double checked(double distance, const Point_3& p)
  {
    if(!(distance >= 0) || !std::isfinite(distance))
      throw std::invalid_argument("the domain contradicts itself: " + point_text(p) +
                                  " is inside, at a distance from the boundary that is " +
                                  (distance < 0 ? "negative" : "not finite"));
    return distance;
  }

  const Domain& m_domain;
  const std::vector<Point_3>& m_points;
  double m_limit;
  std::vector<double> m_distances;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H
