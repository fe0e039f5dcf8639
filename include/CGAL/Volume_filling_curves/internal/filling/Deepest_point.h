// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DEEPEST_POINT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DEEPEST_POINT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

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

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DEEPEST_POINT_H
