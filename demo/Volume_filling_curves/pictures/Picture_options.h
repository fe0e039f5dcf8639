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

// The meaning of the color of a curve.
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

struct Picture_size
{
  std::size_t width = 800, height = 800;
};

struct Picture_options
{
  Coloring coloring = Coloring::COMPONENT;
  std::optional<Vector> direction; // from the curve to the viewer
  Picture_size pixels;
  std::optional<Plane> cut; // hides the viewer's side of it
  bool has_labels = false;
  double tube = 0; // the radius, in the input's unit; 0 for one that suits the picture
};

} // namespace vfc

#endif // VFC_PICTURE_OPTIONS_H
