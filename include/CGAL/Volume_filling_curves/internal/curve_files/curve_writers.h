// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_WRITERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_WRITERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/polylines/Curve_paths.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <array>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Writers of curves, which compose the whole text in memory. Linear time.

inline void append(std::string& text, const std::array<double, 3>& point)
{
  for(const double x : point) {
    text += ' ';
    append_number(text, x);
  }
}

inline void append_line(std::string& text, const std::array<double, 3>& point)
{
  append(text, point);
  text += '\n';
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

inline std::string to_obj(const Curve_paths& curve)
{
  std::string text;
  for(const auto& point : curve.points) {
    text += 'v';
    append_line(text, point);
  }
  for(const auto& path : curve.paths) append_obj_record(text, "l", path);
  if(!curve.pinned.empty()) append_obj_record(text, "fixed", curve.pinned);
  return text;
}

inline std::string to_polylines_txt(const Curve_paths& curve)
{
  std::string text;
  for(const auto& path : curve.paths) {
    text += std::to_string(path.size());
    for(const std::size_t v : path) append(text, curve.points[v]);
    text += '\n';
  }
  return text;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_WRITERS_H
