// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_TEST_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_TEST_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The distance of a point inside a domain from the boundary, or the limit if the domain finds out
// that it is less.
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

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_TEST_H
