// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_LENGTH_WINDOW_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_LENGTH_WINDOW_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Lengths of a growing curve in its last iterations.
struct Length_window
{
  std::vector<double> values;

  void add(double length) { values.push_back(length); }

  // returns whether the length changed by less than this fraction over the last iterations
  bool has_settled(std::size_t iterations, double fraction) const
  {
    if(values.size() <= iterations) return false;
    const auto begin = values.end() - static_cast<std::ptrdiff_t>(iterations) - 1;
    const auto [min, max] = std::minmax_element(begin, values.end());
    return *max - *min < fraction * *max;
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_LENGTH_WINDOW_H
