// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/picture_colors.h"

namespace vfc {

Color mix(const Color& a, const Color& b, double share_of_b)
{
  Color result;
  for(std::size_t k = 0; k < 3; ++k) result[k] = a[k] + share_of_b * (b[k] - a[k]);
  return result;
}

Color component_color(std::size_t component)
{
  constexpr std::array<Color, 8> palette{{{214, 69, 65},
                                          {38, 115, 178},
                                          {235, 160, 35},
                                          {46, 139, 87},
                                          {133, 82, 161},
                                          {0, 150, 160},
                                          {205, 92, 150},
                                          {125, 100, 80}}};
  return palette[component % palette.size()];
}

} // namespace vfc
