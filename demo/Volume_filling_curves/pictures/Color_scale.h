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

// Returns the color of a number, from dark blue for 0 through green to light yellow for 1. Equal
// steps of the number are equal differences of color (the distance in CIELAB, 1976). The lightness
// is monotone, hence the order is visible in grayscale and to color-blind viewers.
Color scale_color(double share);

// Range of numbers, and the ticks to write beside its scale.
struct Color_scale
{
  // Covers all numbers except the lowest and the highest hundredth. \pre there is a number
  explicit Color_scale(std::vector<double> numbers);

  // 0 at the lower end of the range and below, 1 at the upper end and above
  double share(double number) const;

  // from 3 to 7 multiples of 1, 2 or 5 times a power of ten in the range
  std::vector<double> ticks() const;

  double least, largest;
};

} // namespace vfc

#endif // VFC_COLOR_SCALE_H
