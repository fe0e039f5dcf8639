// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Vector or position in space, for geometry in double that decides nothing; the exact predicates of
// the traits take points. Names and the order of sums are those of Eigen's Vector3d, with which it
// is combined in formulas. Expressions of Eigen's own type took a quarter of the time to compile a
// program that untangles (29.7 instead of 22.4 s of g++ 12 at -O3, 2026-11-22).
class Vector
{
public:
  Vector() = default; // zero
  Vector(double x, double y, double z) : m_coordinates{x, y, z} {}

  static Vector constant(double x) { return {x, x, x}; }

  double x() const { return m_coordinates[0]; }
  double y() const { return m_coordinates[1]; }
  double z() const { return m_coordinates[2]; }
  double operator[](int k) const { return m_coordinates[k]; }
  double& operator[](int k) { return m_coordinates[k]; }

  double dot(const Vector& v) const { return x() * v.x() + y() * v.y() + z() * v.z(); }
  double squaredNorm() const { return dot(*this); }
  double norm() const { return std::sqrt(squaredNorm()); }

  // Zero stays zero.
  Vector normalized() const
  {
    const double length = norm();
    return length > 0 ? *this / length : *this;
  }

  Vector cross(const Vector& v) const
  {
    return {y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x()};
  }

  // A unit vector across, for a vector that is not zero.
  Vector unitOrthogonal() const
  {
    constexpr double much_smaller = 1e-12;
    const auto is_small = [&](double x) { return std::abs(x) <= much_smaller * std::abs(z()); };
    if(!is_small(x()) || !is_small(y())) {
      const double scale = 1 / std::sqrt(x() * x() + y() * y());
      return {-y() * scale, x() * scale, 0};
    }
    const double scale = 1 / std::sqrt(y() * y() + z() * z());
    return {0, -z() * scale, y() * scale};
  }

  Vector cwiseAbs() const { return {std::abs(x()), std::abs(y()), std::abs(z())}; }

  Vector cwiseMin(const Vector& v) const
  {
    return {(std::min)(x(), v.x()), (std::min)(y(), v.y()), (std::min)(z(), v.z())};
  }

  Vector cwiseMax(const Vector& v) const
  {
    return {(std::max)(x(), v.x()), (std::max)(y(), v.y()), (std::max)(z(), v.z())};
  }

  double minCoeff() const { return (std::min)((std::min)(x(), y()), z()); }
  double maxCoeff() const { return (std::max)((std::max)(x(), y()), z()); }
  bool allFinite() const { return std::isfinite(x()) && std::isfinite(y()) && std::isfinite(z()); }

  Vector& operator+=(const Vector& v) { return *this = *this + v; }
  Vector& operator-=(const Vector& v) { return *this = *this - v; }
  Vector& operator/=(double s) { return *this = *this / s; }

  friend Vector operator-(const Vector& v) { return {-v.x(), -v.y(), -v.z()}; }

  friend Vector operator+(const Vector& a, const Vector& b)
  {
    return {a.x() + b.x(), a.y() + b.y(), a.z() + b.z()};
  }

  friend Vector operator-(const Vector& a, const Vector& b)
  {
    return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
  }

  friend Vector operator*(const Vector& v, double s) { return {v.x() * s, v.y() * s, v.z() * s}; }
  friend Vector operator*(double s, const Vector& v) { return v * s; }
  friend Vector operator/(const Vector& v, double s) { return {v.x() / s, v.y() / s, v.z() / s}; }

  friend bool operator==(const Vector& a, const Vector& b)
  {
    return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
  }
  friend bool operator!=(const Vector& a, const Vector& b) { return !(a == b); }

private:
  double m_coordinates[3] = {0, 0, 0};
};

// The vector times the power of two that makes its largest coordinate about 1, which is exact.
inline Vector in_own_units(const Vector& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  if(!(largest > 0) || !std::isfinite(largest)) return v;
  const int exponent = -std::ilogb(largest);
  return {std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent), std::ldexp(v.z(), exponent)};
}

// The norm, where the squares of the coordinates may underflow or overflow.
inline double stable_norm(const Vector& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  if(!(largest > 0) || !std::isfinite(largest)) return largest;
  return std::ldexp(in_own_units(v).norm(), std::ilogb(largest));
}

template <typename Point_3>
Vector to_vector(const Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

template <typename Traits>
typename Traits::Point_3 to_point(const Vector& v, const Traits& traits)
{
  return traits.construct_point_3_object()(v.x(), v.y(), v.z());
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_H
