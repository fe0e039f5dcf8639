// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CUTS_H
#define VFC_CUTS_H

#include "pictures/Drawn_curve.h"
#include "pictures/Picture_options.h"
#include "pictures/Triangle_soup.h"
#include "pictures/Vector.h"

#include <array>
#include <cstddef>
#include <vector>

namespace vfc {

// Points p of the picture with normal * p <= offset. The normal has length 1.
struct Half_space
{
  // the distance of a point from the plane, negative inside
  double height(const Vector& p) const { return normal.dot(p) - offset; }

  Vector normal;
  double offset;
};

// Returns the half-space that a cut along a plane leaves. It removes the viewer's side, in the
// direction of z; if the plane is seen edge-on, the side of its normal. \pre the normal has length
// 1
inline Half_space side_kept(const Plane& plane)
{
  constexpr double edge_on = 1e-9;
  if(plane.normal.z() < -edge_on) return {-plane.normal, -plane.offset};
  return {plane.normal, plane.offset};
}

// Removes the part outside the half-space; cut strands get new ends.
void cut(Drawn_curve& curve, const Half_space& half_space);

// Surface after a cut, and the edges along the cut. On a closed surface these edges form loops
// around the inside, oriented like the faces of the removed part.
struct Cut_surface
{
  Triangle_soup soup;
  std::vector<std::array<std::size_t, 2>> rim;
};

Cut_surface cut(const Triangle_soup& surface, const Half_space& half_space);

} // namespace vfc

#endif // VFC_CUTS_H
