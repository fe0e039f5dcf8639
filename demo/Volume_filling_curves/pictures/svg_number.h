// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SVG_NUMBER_H
#define VFC_SVG_NUMBER_H

#include "pictures/Vector.h"
#include "pictures/picture_colors.h"

#include <string>

namespace vfc {

// returns the number with at most two decimals, whatever the locale
std::string svg_number(double x);

std::string svg_coordinates(const Vector& p);

// returns "#" and the six digits of the color
std::string svg_color(const Color& color);

} // namespace vfc

#endif // VFC_SVG_NUMBER_H
