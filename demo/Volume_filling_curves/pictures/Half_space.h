// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_HALF_SPACE_H
#define VFC_HALF_SPACE_H

#include "pictures/Picture_options.h"
#include "pictures/Vector.h"

namespace vfc {

// The points p of the picture with normal * p <= offset. The normal has the length 1.
struct Half_space
{
  // how far a point is outside, negative if it is inside
  double height(const Vector& p) const { return normal.dot(p) - offset; }

  Vector normal;
  double offset;
};

// Returns the half-space that a cut along a plane leaves: the viewer's side, in the direction of z,
// is removed; if the plane is seen edge-on, the side of its normal is removed. \pre the normal has
// length 1
inline Half_space side_kept(const Plane& plane)
{
  constexpr double edge_on = 1e-9;
  if(plane.normal.z() < -edge_on) return {-plane.normal, -plane.offset};
  return {plane.normal, plane.offset};
}

} // namespace vfc

#endif // VFC_HALF_SPACE_H
