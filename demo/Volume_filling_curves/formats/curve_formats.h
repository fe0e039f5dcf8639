// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CURVE_FORMATS_H
#define VFC_CURVE_FORMATS_H

#include "formats/Node_columns.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_format.h>

#include <string>
#include <vector>

namespace vfc {

// A format of the library, or one with columns of values at nodes.
struct Curve_format : CGAL::Volume_filling_curves::internal::Curve_format
{
  using Paths = CGAL::Volume_filling_curves::internal::Curve_paths;

  bool is_written() const { return write != nullptr || write_with_columns != nullptr; }

  std::string (*write_with_columns)(const Paths& curve, const Node_columns& columns) = nullptr;
};

// The table of all formats of curves; a new format is a new line of it.
const std::vector<Curve_format>& curve_formats();

// returns the format of a file by its name, or null
const Curve_format* curve_format_of(const std::string& file);

} // namespace vfc

#endif // VFC_CURVE_FORMATS_H
