// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PICTURE_OPTION_TEXTS_H
#define VFC_PICTURE_OPTION_TEXTS_H

#include "pictures/Picture_options.h"

#include <optional>
#include <string>

namespace vfc {

// Parsers of picture options. They return nothing for an invalid text.

// "x,y,z", or "azimuth,elevation" in degrees: from the z axis towards the x axis, and from there
// towards the y axis
std::optional<Vector> parse_direction(const std::string& text);

// Size of a picture in pixels, from 100 to 4000: one number for both sides, or width and height as
// in 1600x900
std::optional<Picture_size> parse_size(const std::string& text);

// "x=0.5", "y=0.5", "z=0.5", or "a,b,c,d" for the points with a x + b y + c z = d
std::optional<Plane> parse_plane(const std::string& text);

} // namespace vfc

#endif // VFC_PICTURE_OPTION_TEXTS_H
