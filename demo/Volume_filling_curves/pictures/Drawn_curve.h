// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_DRAWN_CURVE_H
#define VFC_DRAWN_CURVE_H

#include "pictures/Curve_view.h"
#include "pictures/edge_values.h"
#include "pictures/strands.h"

#include <array>
#include <cstddef>
#include <vector>

namespace vfc {

struct Drawn_edge
{
  std::size_t source, target;
  std::array<double, 2> values; // shown as colors, at both ends
};

// Curve in picture coordinates, or its remainder after a cut.
struct Drawn_curve
{
  Drawn_curve(const Curve& curve, const Curve_view& view, const Edge_values& values);

  std::vector<Vector> points;
  std::vector<std::size_t> numbers; // of the points in the file, from 1; 0 for new points
  std::vector<Drawn_edge> edges;
  std::vector<Strand> strands;
  std::vector<std::size_t> ends; // points drawn as dots: ends and junctions
  double width;                  // of the stroke
};

} // namespace vfc

#endif // VFC_DRAWN_CURVE_H
