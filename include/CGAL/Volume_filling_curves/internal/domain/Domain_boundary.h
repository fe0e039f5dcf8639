// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_BOUNDARY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_BOUNDARY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Unbounded_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Distance_bounds.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The boundary of a domain, as the flow sees it: what a triangle must miss (exact), and how large a
// sphere that touches a node inside may be. Nearly all questions are answered by a bound of the
// distance to the boundary. Safe to ask in parallel.
template <typename Domain>
class Domain_boundary
{
  using Point_3 = typename Domain::Point_3;

public:
  static constexpr bool is_bounded = true;

  explicit Domain_boundary(const Domain& domain) : m_domain(&domain), m_bounds(domain) {}

  const Domain& domain() const { return *m_domain; }

  // returns whether the closed triangle lies inside. \pre p lies inside
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    const Vector x = to_vector(p);
    const double reach = (std::max)((to_vector(q) - x).norm(), (to_vector(r) - x).norm());
    return m_bounds(p, x, reach) > reach || m_domain->is_triangle_inside(p, q, r);
  }

  // returns a distance that p is known to have from the boundary; all of it if that is below
  // `needed`
  double clearance(const Point_3& p, double needed) const
  {
    return m_bounds(p, to_vector(p), needed);
  }

  // How far the center of a sphere can go from p before it leaves the domain, at most `limit`.
  double distance_along(const Point_3& p, const Vector& direction, double limit) const
  {
    using Vector_3 = typename Domain::Vector_3;
    return m_domain->distance_along(p, Vector_3(direction.x(), direction.y(), direction.z()),
                                    limit);
  }

  // The radius, at most `limit`, of the largest sphere inside that touches p and has its center in
  // the direction from p. Of such spheres the larger ones hold the smaller ones: bisection.
  template <typename Traits>
  double tangent_radius(const Point_3& p,
                        const Vector& direction,
                        double limit,
                        const Traits& traits) const
  {
    const Vector x = to_vector(p);
    const auto is_inside = [&](double radius) {
      const Point_3 center = to_point(Vector(x + radius * direction), traits);
      return m_domain->is_inside(center) && m_domain->distance(center) >= (1 - tolerance) * radius;
    };
    if(is_inside(limit)) return limit;
    double low = 0, high = limit;
    while(high - low > tolerance * high) {
      const double middle = (low + high) / 2;
      (is_inside(middle) ? low : high) = middle;
      if(high < least_radius * limit) break;
    }
    return high;
  }

private:
  static constexpr double tolerance = 1e-4;    // of a radius, relative
  static constexpr double least_radius = 1e-6; // in units of the limit

  const Domain* m_domain;
  Distance_bounds<Domain> m_bounds;
};

// There are none.
template <typename GeomTraits>
class Domain_boundary<Unbounded_domain_3<GeomTraits>>
{
public:
  static constexpr bool is_bounded = false;

  Domain_boundary() = default;
  explicit Domain_boundary(const Unbounded_domain_3<GeomTraits>&) {}
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_BOUNDARY_H
