// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_FRAME_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_FRAME_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <cmath>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_FRAME_H
