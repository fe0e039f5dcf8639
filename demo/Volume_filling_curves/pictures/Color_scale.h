// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_COLOR_SCALE_H
#define VFC_COLOR_SCALE_H

#include "pictures/picture_colors.h"

#include <vector>

namespace vfc {

// Color scale of numbers, from dark blue for 0 through green to light yellow for 1: equal steps of
// the number are equal differences of color (the distance in CIELAB, 1976), and the lightness is
// monotone, hence the order is visible in grayscale and to color-blind viewers.
Color scale_color(double share);

// A range of numbers, and which of them to write beside a scale.
struct Color_scale
{
  // Covers all numbers except the lowest and the highest hundredth. \pre there is one
  explicit Color_scale(std::vector<double> numbers);

  // 0 at the least end of the range and below, 1 at the other and above
  double share(double number) const;

  // from 3 to 7 multiples of 1, 2 or 5 times a power of ten in the range
  std::vector<double> ticks() const;

  double least, largest;
};

} // namespace vfc

#endif // VFC_COLOR_SCALE_H
