// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_ELEMENTARY_FUNCTIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_ELEMENTARY_FUNCTIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Cube root of a nonnegative number, by Newton's method in IEEE operations only. The library's
// function differs in its last bit between platforms; linked samples and generated knots must not.
// The error is squared in each step.
inline double cube_root(double x)
{
  if(!(x > 0) || !std::isfinite(x)) return x;
  const int exponent = static_cast<int>(std::floor(std::ilogb(x) / 3.));
  const double mantissa = std::ldexp(x, -3 * exponent); // in [1, 8)
  double root = 1.5;
  for(int k = 0; k < 6; ++k) root = (2 * root + mantissa / (root * root)) / 3;
  return std::ldexp(root, exponent);
}

// The point (cos, sin) of the unit circle after `turns` full turns. The library's cos and sin
// differ in their last bits between platforms; generated curves and sampled directions must not. So
// the angle is reduced to an eighth of a turn, exactly, and the Taylor series, whose first omitted
// terms are below 1e-17 there, is summed with IEEE additions and multiplications only.
inline std::array<double, 2> cos_sin(double turns)
{
  constexpr double two_pi = 6.283185307179586476925286766559;
  const double quarters = std::floor(4 * turns + 0.5);
  const double x = two_pi * (turns - quarters / 4), xx = x * x;
  double c = 1, s = 1;
  for(int k = 16; k > 0; k -= 2) {
    c = 1 - c * xx / (k * (k - 1));
    s = 1 - s * xx / (k * (k + 1));
  }
  s *= x;
  switch(static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
  case 0:
    return {c, s};
  case 1:
    return {-s, c};
  case 2:
    return {-c, -s};
  default:
    return {s, -c};
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_ELEMENTARY_FUNCTIONS_H
