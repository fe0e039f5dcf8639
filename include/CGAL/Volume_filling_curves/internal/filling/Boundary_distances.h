// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/distance_up_to.h>
#include <CGAL/Volume_filling_curves/internal/support/Deadline.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// How far points inside a domain are from its boundary. They are measured up to a limit, since of
// most points no more has to be known, and those of the bunny then take a fifth of the time; beyond
// the limit the domain is asked again. After the deadline, if there is one, the distances are left
// at 0, but for that of the first point.
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
                     const Deadline* deadline = nullptr,
                     ConcurrencyTag = {})
      : m_domain(domain), m_points(points), m_limit(limit), m_distances(points.size(), 0)
  {
    constexpr std::size_t block = 256;
    for_each_block<ConcurrencyTag>(points.size(), block, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        if(k == 0 || !deadline || !deadline->has_passed())
          m_distances[k] = distance_up_to(domain, points[k], limit);
    });
  }

  // of the k-th point
  double operator[](std::size_t k) const
  {
    return m_distances[k] < m_limit ? m_distances[k] : m_domain.distance(m_points[k]);
  }

  // of all points; those that reach the limit may be larger
  const std::vector<double>& up_to_limit() const { return m_distances; }

  double limit() const { return m_limit; }

private:
  const Domain& m_domain;
  const std::vector<Point_3>& m_points;
  double m_limit;
  std::vector<double> m_distances;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_BOUNDARY_DISTANCES_H
