// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PNG_FILE_H
#define VFC_PNG_FILE_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vfc {

struct Rgb_image
{
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> bytes; // red, green and blue of every pixel, rows from the top
};

// returns the bytes of a PNG file
std::string to_png(const Rgb_image& image);

} // namespace vfc

#endif // VFC_PNG_FILE_H
