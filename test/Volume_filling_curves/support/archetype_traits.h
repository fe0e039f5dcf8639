// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_ARCHETYPE_TRAITS_H
#define VFC_TEST_ARCHETYPE_TRAITS_H

#include "support/brute_force_curve.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>

namespace archetypes {

using brute_force::operator-;
using Rational = CGAL::Exact_rational;

// A model of `CurveFlowTraits_3` and no more: not even default construction.
struct Archetype
{
  class Point_3
  {
  public:
    Point_3(double x, double y, double z, int) : m_coordinates{x, y, z} {}
    double x() const { return m_coordinates[0]; }
    double y() const { return m_coordinates[1]; }
    double z() const { return m_coordinates[2]; }
    bool operator==(const Point_3&) const = delete;
    bool operator<(const Point_3&) const = delete;

  private:
    std::array<double, 3> m_coordinates;
  };

  class Vector_3
  {
  public:
    Vector_3(double x, double y, double z) : m_coordinates{x, y, z} {}
    double x() const { return m_coordinates[0]; }
    double y() const { return m_coordinates[1]; }
    double z() const { return m_coordinates[2]; }

  private:
    std::array<double, 3> m_coordinates;
  };

  struct Functor
  {
    explicit Functor(int) {}
    Functor& operator=(const Functor&) = delete;
    Functor(const Functor&) = default;
    static brute_force::Vec<Rational> exact(const Point_3& p) { return {p.x(), p.y(), p.z()}; }
  };

  struct Construct_point_3 : Functor
  {
    using Functor::Functor;
    Point_3 operator()(double x, double y, double z) const { return {x, y, z, 0}; }
  };

  struct Orientation_3 : Functor
  {
    using Functor::Functor;
    CGAL::Orientation operator()(const Point_3& p,
                                 const Point_3& q,
                                 const Point_3& r,
                                 const Point_3& s) const
    {
      const auto a = exact(p);
      return CGAL::Orientation(
          brute_force::sign_of(brute_force::det(exact(q) - a, exact(r) - a, exact(s) - a)));
    }
  };

  // the first of the normal's coordinates z, x, y that is not zero
  struct Coplanar_orientation_3 : Functor
  {
    using Functor::Functor;
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      const auto normal = brute_force::cross(exact(q) - exact(p), exact(r) - exact(p));
      for(std::size_t k : {2u, 0u, 1u})
        if(normal[k] != 0) return CGAL::Orientation(brute_force::sign_of(normal[k]));
      return CGAL::COLLINEAR;
    }
  };

  struct Less_xyz_3 : Functor
  {
    using Functor::Functor;
    bool operator()(const Point_3& p, const Point_3& q) const { return exact(p) < exact(q); }
  };

  explicit Archetype(int) {}

  Construct_point_3 construct_point_3_object() const { return Construct_point_3(0); }
  Orientation_3 orientation_3_object() const { return Orientation_3(0); }
  Coplanar_orientation_3 coplanar_orientation_3_object() const { return Coplanar_orientation_3(0); }
  Less_xyz_3 less_xyz_3_object() const { return Less_xyz_3(0); }
};

} // namespace archetypes

#endif // VFC_TEST_ARCHETYPE_TRAITS_H
