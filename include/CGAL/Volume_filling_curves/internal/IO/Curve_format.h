// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_CURVE_FORMAT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_CURVE_FORMAT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/IO/Curve_file.h>
#include <CGAL/Volume_filling_curves/internal/IO/Curve_strands.h>
#include <CGAL/Volume_filling_curves/internal/IO/Obj_curve_reader.h>
#include <CGAL/Volume_filling_curves/internal/IO/Polylines_txt_reader.h>
#include <CGAL/Volume_filling_curves/internal/IO/curve_writers.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The formats of curve files. The end of the file's name decides, in upper or lower case; a new
// format is a new line of the table.
struct Curve_format
{
  std::string_view extension;
  Curve_file (*read)(std::string_view text, Junctions junctions);
  std::string (*write)(const Curve_strands& curve);

  // returns null if the format is unknown
  static const Curve_format* of(const std::string& filename);
};

inline Curve_file read_obj(std::string_view text, Junctions)
{
  return Obj_curve_reader(text).run();
}

inline Curve_file read_polylines_txt(std::string_view text, Junctions junctions)
{
  return Polylines_txt_reader(text, junctions).run();
}

inline const Curve_format* Curve_format::of(const std::string& filename)
{
  static constexpr Curve_format formats[] = {
      {".obj", read_obj, to_obj}, {".polylines.txt", read_polylines_txt, to_polylines_txt}};
  const auto is_same_letter = [](char small, char c) {
    return small == (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  };
  for(const Curve_format& format : formats) {
    const std::size_t length = format.extension.size();
    if(filename.size() >= length &&
       std::equal(format.extension.begin(), format.extension.end(),
                  filename.end() - std::ptrdiff_t(length), is_same_letter))
      return &format;
  }
  return nullptr;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_CURVE_FORMAT_H
