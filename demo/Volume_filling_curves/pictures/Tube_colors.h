// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TUBE_COLORS_H
#define VFC_TUBE_COLORS_H

#include "pictures/Color_scale.h"
#include "pictures/edge_values.h"
#include "pictures/picture_colors.h"

#include <cstddef>
#include <optional>

namespace vfc {

// The colors of a curve: one per component, or those of a scale.
class Tube_colors
{
public:
  Tube_colors(Coloring coloring, const Edge_values& values);

  // the color at a distance, from 1 for the nearest point to 0 for the farthest. Distant colors are
  // pale, but not enough to be mistaken for another color of the scale.
  Color color(double value, double nearness) const;

  // Of the values that are drawn with the same color when colors are few.
  std::size_t level(double value) const;
  double value_of_level(std::size_t level) const;

  // the difference of values of a level and the next one, infinite if there is no scale
  double level_step() const;

  // empty if components have colors of their own
  const std::optional<Color_scale>& scale() const { return m_scale; }

private:
  std::optional<Color_scale> m_scale;
};

} // namespace vfc

#endif // VFC_TUBE_COLORS_H
