// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PICTURE_OPTIONS_H
#define VFC_PICTURE_OPTIONS_H

#include "pictures/Vector.h"

#include <cstddef>
#include <optional>

namespace vfc {

// What the color of a curve tells.
enum class Coloring
{
  COMPONENT,
  ARCLENGTH,
  RADIUS,
  CURVATURE,
  THICKNESS
};

// The points p with normal * p = offset, in the input's coordinates.
struct Plane
{
  Vector normal;
  double offset;
};

struct Picture_options
{
  Coloring coloring = Coloring::COMPONENT;
  std::optional<Vector> direction; // from the curve to the viewer
  std::size_t pixels = 800;        // of each side
  std::optional<Plane> cut;        // what is on the viewer's side of it is left out
  bool has_labels = false;
};

} // namespace vfc

#endif // VFC_PICTURE_OPTIONS_H
