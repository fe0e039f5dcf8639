// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_APPEND_NUMBER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_APPEND_NUMBER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <charconv>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// With 17 significant digits and without a locale, so that reading gives back the very same double.
inline void append_number(std::string& text, double number)
{
  const int number_of_digits = 17;
  std::array<char, 32> buffer; // sign, point, 17 digits, e-308
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                    std::chars_format::general, number_of_digits);
  text.append(buffer.data(), result.ptr);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_APPEND_NUMBER_H
