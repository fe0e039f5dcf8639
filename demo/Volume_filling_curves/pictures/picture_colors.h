// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PICTURE_COLORS_H
#define VFC_PICTURE_COLORS_H

#include <array>
#include <cstddef>

namespace vfc {

// Color with red, green and blue from 0 to 255.
using Color = std::array<double, 3>;

Color mix(const Color& a, const Color& b, double share_of_b);

Color component_color(std::size_t component);

// the color of infinite distance
inline constexpr Color fog_color{206, 214, 224};

} // namespace vfc

#endif // VFC_PICTURE_COLORS_H
