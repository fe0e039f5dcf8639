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
#include <limits>
#include <stdexcept>
#include <string>

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

// Returns the power of two that scales a size to about 1, or the largest power of two. Scaling by
// it is exact. \pre the size is positive and finite
inline double scale_to_one(double size)
{
  constexpr int max_exponent = std::numeric_limits<double>::max_exponent - 1;
  return std::ldexp(1., (std::min)(-std::ilogb(size), max_exponent));
}

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

// Range of the coordinates that networks, readers, domains and guards accept, and least size of the
// bounding box of a curve that moves: squares of lengths neither overflow nor underflow.
constexpr double max_coordinate = 1e150, min_extent = 1e-150;

// returns whether all coordinates are accepted; NaN is not
inline bool is_in_range(const Vector& x)
{
  for(int k = 0; k < 3; ++k)
    if(!(std::abs(x[k]) <= max_coordinate)) return false;
  return true;
}

// Throws std::invalid_argument, with `name` in the message, unless the coordinates are accepted.
inline void check_range(const Vector& x, const std::string& name)
{
  if(!x.allFinite()) throw std::invalid_argument(name + " is not finite");
  if(!is_in_range(x)) throw std::invalid_argument(name + " has a coordinate beyond 1e150");
}

// Orthonormal frame: the three rows of a rotation of space.
struct Frame
{
  Vector first, second, third;

  Vector operator()(const Vector& v) const { return {first.dot(v), second.dot(v), third.dot(v)}; }
};

// The quaternion need not have length 1.
inline Frame frame_of_quaternion(double w, double x, double y, double z)
{
  const double norm = std::sqrt(w * w + x * x + y * y + z * z);
  w /= norm, x /= norm, y /= norm, z /= norm;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

// A direction without symmetries, for looking at curves that often lie on a lattice.
inline Frame generic_frame()
{
  return frame_of_quaternion(0.771, 0.371, -0.291, 0.427);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_H
