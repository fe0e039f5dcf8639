// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_CURVE_WRITERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_CURVE_WRITERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/IO/Curve_strands.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Writers of curves compose the whole text in memory; 17 significant digits and no locale, so that
// reading gives back the very same doubles. Linear time.

inline void append(std::string& text, double number)
{
  const int number_of_digits = 17;
  std::array<char, 32> buffer; // sign, point, 17 digits, e-308
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                    std::chars_format::general, number_of_digits);
  text.append(buffer.data(), result.ptr);
}

inline void append(std::string& text, const std::array<double, 3>& point)
{
  for(const double x : point) {
    text += ' ';
    append(text, x);
  }
}

template <typename Indices>
void append_obj_record(std::string& text, const char* keyword, const Indices& indices)
{
  text += keyword;
  for(const std::size_t v : indices) {
    text += ' ';
    text += std::to_string(v + 1);
  }
  text += '\n';
}

inline std::string to_obj(const Curve_strands& curve)
{
  std::string text;
  for(const auto& point : curve.points) {
    text += 'v';
    append(text, point);
    text += '\n';
  }
  for(const auto& strand : curve.strands) append_obj_record(text, "l", strand);
  if(!curve.pinned.empty()) append_obj_record(text, "fixed", curve.pinned);
  return text;
}

inline std::string to_polylines_txt(const Curve_strands& curve)
{
  std::string text;
  for(const auto& strand : curve.strands) {
    text += std::to_string(strand.size());
    for(const std::size_t v : strand) append(text, curve.points[v]);
    text += '\n';
  }
  return text;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_CURVE_WRITERS_H
