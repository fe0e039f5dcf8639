// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_WITHOUT_SEGMENTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_WITHOUT_SEGMENTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Domain from which a layer along the boundary and segments are removed, for the search for paths
// around them.
template <typename Domain>
class Domain_without_segments
{
public:
  using Point_3 = typename Domain::Point_3;
  using Segment = std::array<Vector, 2>;

  static constexpr int dimension = dimension_of<Domain>;

  Domain_without_segments(const Domain& domain, double layer) : m_domain(domain), m_layer(layer) {}

  void remove(const Vector& p, const Vector& q) { m_segments.push_back({p, q}); }
  void remove(const std::vector<Vector>& path)
  {
    for(std::size_t k = 1; k < path.size(); ++k) remove(path[k - 1], path[k]);
  }

  CGAL::Bbox_3 bbox() const { return m_domain.bbox(); }
  bool is_inside(const Point_3& p) const { return m_domain.is_inside(p) && distance(p) > 0; }

  double distance(const Point_3& p) const
  {
    return (std::min)(static_cast<double>(m_domain.distance(p)) - m_layer, distance_to_segments(p));
  }

private:
  double distance_to_segments(const Point_3& p) const
  {
    double least = std::numeric_limits<double>::infinity();
    for(const Segment& s : m_segments)
      least = (std::min)(least, squared_distance_to_segment(to_vector(p), s[0], s[1]));
    return std::sqrt(least);
  }

  const Domain& m_domain;
  const double m_layer;
  std::vector<Segment> m_segments;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_WITHOUT_SEGMENTS_H
