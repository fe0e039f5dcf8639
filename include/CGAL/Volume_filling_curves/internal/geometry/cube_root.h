// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_CUBE_ROOT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_CUBE_ROOT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cmath>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The cube root of a number that is not negative. The library's differs in its last bit between
// platforms; samples that are linked by distance, and generated knots, must not. Newton's method,
// whose error is squared in each step, starts near the root and takes IEEE operations only.
inline double cube_root(double x)
{
  if(!(x > 0) || !std::isfinite(x)) return x;
  const int exponent = static_cast<int>(std::floor(std::ilogb(x) / 3.));
  const double mantissa = std::ldexp(x, -3 * exponent); // in [1, 8)
  double root = 1.5;
  for(int k = 0; k < 6; ++k) root = (2 * root + mantissa / (root * root)) / 3;
  return std::ldexp(root, exponent);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_CUBE_ROOT_H
