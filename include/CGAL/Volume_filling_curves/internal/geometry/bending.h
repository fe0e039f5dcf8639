// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BENDING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BENDING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The vector times the power of two that makes its largest coordinate about 1, which is exact.
inline Vector in_own_units(const Vector& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  if(!(largest > 0) || !std::isfinite(largest)) return v;
  const int exponent = -std::ilogb(largest);
  return {std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent), std::ldexp(v.z(), exponent)};
}

// The angle between two consecutive edges, in [0, pi]. atan2 is accurate for straight and for
// folded corners alike, where acos loses half of the digits. The edges are scaled, lest products
// underflow and overflow: a knot of size 1e-100 would look straight.
inline double turning_angle(const Vector& in, const Vector& out)
{
  const Vector u = in_own_units(in), v = in_own_units(out);
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

// The radius of the arc that is tangent to both edges at a corner and touches the shorter one in
// its middle (Rawdon 1998); infinite if straight, 0 if folded.
inline double bend_radius(const Vector& in, const Vector& out)
{
  const double angle = turning_angle(in, out);
  if(!(angle > 0)) return std::numeric_limits<double>::infinity();
  return (std::min)(in.norm(), out.norm()) / (2 * std::tan(angle / 2));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BENDING_H
