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

// Colors of a curve: one per component, or those of a scale.
class Tube_colors
{
public:
  Tube_colors(Coloring coloring, const Edge_values& values);

  // Returns the color at a nearness from 1 for the nearest point to 0 for the farthest. Distant
  // colors are paler, but not like another color of the scale.
  Color color(double value, double nearness) const;

  // Returns the level of a value; pictures with few colors have one per level.
  std::size_t level(double value) const;
  double value_of_level(std::size_t level) const;

  // the difference of values between levels, infinite without a scale
  double level_step() const;

  // empty if each component has its own color
  const std::optional<Color_scale>& scale() const { return m_scale; }

private:
  std::optional<Color_scale> m_scale;
};

} // namespace vfc

#endif // VFC_TUBE_COLORS_H
