// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BENDING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BENDING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Angle in [0, pi/4] with the tangent t in [0, 1], in IEEE operations only: the library's functions
// differ in their last bits between platforms, and bends decide when a run ends. The angle is
// halved until the first omitted term of the Taylor series is below 1e-17.
inline double arc_tangent(double t)
{
  constexpr double small = 0.2;
  double factor = 1;
  for(; t > small; factor *= 2) t /= 1 + std::sqrt(1 + t * t);
  double sum = 0;
  for(int k = 21; k > 0; k -= 2) sum = 1. / k - t * t * sum;
  return factor * t * sum;
}

// The tangent of half of the angle between two consecutive edges, in [0, infinity]. It is accurate
// for straight and for folded corners alike, where the cosine loses half of the digits. The edges
// are scaled, lest products underflow and overflow: a knot of size 1e-100 would look straight.
inline double half_turn_tangent(const Vector& in, const Vector& out)
{
  const Vector u = in_own_units(in), v = in_own_units(out);
  const double sine = u.cross(v).norm(), cosine = u.dot(v);
  if(sine == 0) return cosine < 0 ? std::numeric_limits<double>::infinity() : 0;
  const double norm = std::sqrt(u.squaredNorm() * v.squaredNorm());
  return cosine > 0 ? sine / (norm + cosine) : (norm - cosine) / sine;
}

// The angle between two consecutive edges, in [0, pi].
inline double turning_angle(const Vector& in, const Vector& out)
{
  const double t = half_turn_tangent(in, out);
  return t <= 1 ? 2 * arc_tangent(t) : CGAL_PI - 2 * arc_tangent(1 / t);
}

// The radius of the arc that is tangent to both edges at a corner and touches the shorter one in
// its middle (Rawdon 1998); infinite if straight, 0 if folded.
inline double bend_radius(const Vector& in, const Vector& out)
{
  const double t = half_turn_tangent(in, out);
  if(!(t > 0)) return std::numeric_limits<double>::infinity();
  return (std::min)(in.norm(), out.norm()) / (2 * t);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BENDING_H
