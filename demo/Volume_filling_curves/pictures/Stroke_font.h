// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_STROKE_FONT_H
#define VFC_STROKE_FONT_H

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace vfc {

using Segment_2 = std::array<Eigen::Vector2d, 2>;

// Stroke font for pictures, so that no font library is needed: digits, signs of numbers, and the
// letters that pictures use; other characters are blank. Digits are `size` high.

// returns the strokes of a text that starts at a point of the base line; y points downwards
std::vector<Segment_2> text_strokes(const std::string& text,
                                    const Eigen::Vector2d& start,
                                    double size);

double text_width(const std::string& text, double size);

} // namespace vfc

#endif // VFC_STROKE_FONT_H
