// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Depth of points, segments and triangles inside a domain: their distance from its boundary, found
// by queries at points, which every domain answers, or by functions that only some domains have.

// Distance from a point inside a domain to the boundary, 0 outside.
template <typename Domain>
double depth(const Domain& domain, const typename Domain::Point_3& p)
{
  return domain.is_inside(p) ? domain.distance(p) : 0;
}

// The distance of a point inside a domain from the boundary. A domain with a surface searches only
// up to the limit, and returns it if the distance is larger.
template <typename Domain>
double depth_up_to(const Domain& domain,
                   const typename Domain::Point_3& p,
                   [[maybe_unused]] double limit)
{
  if constexpr(Has_surface<Domain>::value)
    return domain.distance_up_to(p, limit);
  else
    return domain.distance(p);
}

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

  // No point of a segment of length L is nearer than (d + e - L) / 2, where d and e are the
  // distances of its ends.
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

// Bound of the errors of distances, and of points halfway between others, in a box; more than usual
// far from the origin, where coordinates are coarse.
inline double rounding_in(const CGAL::Bbox_3& box, double usual)
{
  constexpr double units = 4; // in the last place of a coordinate
  const Vector low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  const double largest = (std::max)(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  return (std::max)(usual, units * std::numeric_limits<double>::epsilon() * largest);
}

// Test whether a whole triangle inside a domain, which may be degenerate, is farther than c from
// the boundary. This holds if the middle of the longest side is farther than c plus the reach of
// the triangle from it; otherwise the triangle is halved there. The answer is as certain as the
// domain's distances, and is no in doubtful cases: if the triangle comes within 1/64 of its size of
// the limit. One query far from the boundary, some hundreds in the worst case.
template <typename Domain>
class Depth_test
{
  using Point_3 = typename Domain::Point_3;

public:
  // Takes c, to which the caller has added the error of distances.
  Depth_test(const Domain& domain, double c) : m_domain(domain), m_c(c) {}

  bool operator()(const Vector& p, const Vector& q, const Vector& r) const
  {
    const double size = (std::max)({(q - p).norm(), (r - q).norm(), (p - r).norm()});
    return is_deeper(p, q, r, finest * size);
  }

private:
  static constexpr double finest = 1. / 64; // of the size, at which halving ends

  bool is_deeper(const Vector& p, const Vector& q, const Vector& r, double min_reach) const
  {
    const double pq = (q - p).squaredNorm(), qr = (r - q).squaredNorm();
    const double rp = (p - r).squaredNorm();
    if(pq >= qr && pq >= rp) return is_deeper_along(p, q, r, min_reach);
    return qr >= rp ? is_deeper_along(q, r, p, min_reach) : is_deeper_along(r, p, q, min_reach);
  }

  // \pre pq is the longest side
  bool is_deeper_along(const Vector& p, const Vector& q, const Vector& r, double min_reach) const
  {
    const Vector middle = (p + q) / 2;
    const double reach = (std::max)((q - p).norm() / 2, (r - middle).norm());
    const double needed = m_c + reach;
    constexpr double excess = 1 + 1e-9; // distances end at the limit
    const double depth =
        depth_up_to(m_domain, Point_3(middle.x(), middle.y(), middle.z()), excess * needed);
    if(depth > needed) return true;
    if(!(depth > m_c) || reach <= min_reach) return false;
    return is_deeper(p, middle, r, min_reach) && is_deeper(middle, q, r, min_reach);
  }

  const Domain& m_domain;
  const double m_c;
};

// Differences of the distance from the boundary between the points a step before and behind x along
// the axes that are asked for: 2 steps times the gradient, which has a length of 1 near a single
// wall, less near several, and 0 halfway between two. Every domain has them.
// \pre the step is shorter than the distance at x
template <typename Domain, typename Traits>
Vector depth_differences(const Domain& domain,
                         const Vector& x,
                         double step,
                         const std::array<bool, 3>& is_axis,
                         const Traits& traits)
{
  const auto depth_at = [&](int axis, double offset) {
    Vector p = x;
    p[axis] += offset;
    return domain.distance(to_point(p, traits));
  };
  Vector differences;
  for(std::size_t i = 0; i < 3; ++i)
    if(is_axis[i]) {
      const int axis = static_cast<int>(i);
      differences[axis] = depth_at(axis, step) - depth_at(axis, -step);
    }
  return differences;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_H
