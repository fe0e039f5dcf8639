// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_OF_SEGMENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_OF_SEGMENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The least distance of a segment inside to the boundary of a domain that knows points only, and
// the position on the segment, from 0 to 1. Distances are 1-Lipschitz: the segment is halved until
// nothing on it can be nearer by more than a thousandth of the distance, or of half of the segment.
template <typename Domain>
class Segment_halving
{
  using Point_3 = typename Domain::Point_3;

public:
  Segment_halving(const Domain& domain, const Point_3& p, const Point_3& q)
      : m_domain(domain), m_p(to_vector(p)), m_q(to_vector(q))
  {}

  std::pair<double, double> operator()()
  {
    const double at_p = distance(0), at_q = distance(1);
    m_nearest = at_q < at_p ? std::make_pair(at_q, 1.) : std::make_pair(at_p, 0.);
    halve(0, at_p, 1, at_q);
    return m_nearest;
  }

private:
  static constexpr double precision = 1e-3; // relative

  double distance(double position) const
  {
    const Vector x = m_p + position * (m_q - m_p);
    return m_domain.distance(Point_3(x.x(), x.y(), x.z()));
  }

  // No point of a segment is nearer than half of the sum of the distances of its ends minus its
  // length.
  void halve(double a, double at_a, double b, double at_b)
  {
    const double length = (m_q - m_p).norm();
    const double least = (at_a + at_b - (b - a) * length) / 2;
    if(!(least < m_nearest.first - precision * (std::max)(length / 2, m_nearest.first))) return;
    const double middle = (a + b) / 2, at_middle = distance(middle);
    if(at_middle < m_nearest.first) m_nearest = {at_middle, middle};
    halve(a, at_a, middle, at_middle);
    halve(middle, at_middle, b, at_b);
  }

  const Domain& m_domain;
  const Vector m_p, m_q;
  std::pair<double, double> m_nearest;
};

// The least distance of a segment inside a domain to its boundary, and the position on the segment.
// Meshes and polygons measure it up to rounding.
template <typename Domain>
std::pair<double, double> depth_of_segment(const Domain& domain,
                                           const typename Domain::Point_3& p,
                                           const typename Domain::Point_3& q)
{
  if constexpr(Measures_segments<Domain>::value)
    return domain.distance_of_segment(p, q);
  else
    return Segment_halving<Domain>(domain, p, q)();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_OF_SEGMENT_H
