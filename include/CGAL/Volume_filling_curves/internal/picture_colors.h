// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PICTURE_COLORS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PICTURE_COLORS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The colors of pictures, with channels from 0 to 255.
using Color = std::array<double, 3>;

inline Color mix(const Color& a, const Color& b, double share)
{
  Color result;
  for(std::size_t k = 0; k < 3; ++k) result[k] = a[k] + share * (b[k] - a[k]);
  return result;
}

inline const Color& component_color(std::size_t component)
{
  static constexpr std::array<Color, 8> palette{{{214, 69, 65},
                                                 {38, 115, 178},
                                                 {235, 160, 35},
                                                 {46, 139, 87},
                                                 {133, 82, 161},
                                                 {0, 150, 160},
                                                 {205, 92, 150},
                                                 {125, 100, 80}}};
  return palette[component % palette.size()];
}

// of what is far away
inline constexpr Color fog_color{206, 214, 224};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PICTURE_COLORS_H
