// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_BOUNDARY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_BOUNDARY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Distance_bounds.h>
#include <CGAL/Volume_filling_curves/internal/domain/Planar_rays.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Whether a domain shortens all rays of a plane at once, see `Face_tree`.
template <typename Domain, typename = void>
struct Shortens_planar_rays : std::false_type
{};

template <typename Domain>
struct Shortens_planar_rays<
    Domain,
    std::void_t<decltype(std::declval<const Domain&>().shorten(std::declval<Planar_rays&>()))>>
    : std::true_type
{};

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

  // returns whether x, inside, is known to be farther from the boundary than that
  bool is_farther(const Vector& x, double distance) const
  {
    return m_bounds.is_farther(x, distance);
  }

  // Shortens rays from p to where they leave the domain.
  void shorten(const Point_3& p, Planar_rays& rays) const
  {
    if constexpr(Shortens_planar_rays<Domain>::value)
      m_domain->shorten(rays);
    else {
      using Vector_3 = typename Domain::Vector_3;
      const double clear = clearance(p, rays.longest());
      for(std::size_t l = 0; l < rays.size(); ++l)
        if(rays.lengths[l] >= clear)
          rays.lengths[l] = m_domain->distance_along(p, Vector_3(rays.x[l], rays.y[l], rays.z[l]),
                                                     rays.lengths[l]);
    }
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
