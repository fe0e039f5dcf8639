// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_ARCHETYPE_DOMAIN_H
#define VFC_TEST_ARCHETYPE_DOMAIN_H

#include <CGAL/Bbox_3.h>

#include <limits>

namespace archetypes {

// A model of `VolumeFillingDomain_3` and no more: the half space z > 0. Neither default
// constructible nor copyable.
template <typename Point>
class Domain
{
public:
  typedef Point Point_3;

  class Vector_3
  {
  public:
    Vector_3(double, double, double z) : m_z(z) {}
    Vector_3(const Vector_3&) = delete;
    Vector_3& operator=(const Vector_3&) = delete;

  private:
    friend class Domain;
    double m_z;
  };

  explicit Domain(int) {}
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  CGAL::Bbox_3 bbox() const
  {
    const double infinity = std::numeric_limits<double>::infinity();
    return {-infinity, -infinity, 0, infinity, infinity, infinity};
  }

  bool is_inside(const Point_3& p) const { return p.z() > 0; }

  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return is_inside(p) && is_inside(q) && is_inside(r);
  }

  double distance(const Point_3& p) const { return p.z() > 0 ? p.z() : 0; }

  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const
  {
    const double uz = direction.m_z;
    return uz < 0 && p.z() < -uz * limit ? p.z() / -uz : limit;
  }
};

} // namespace archetypes

#endif // VFC_TEST_ARCHETYPE_DOMAIN_H
