// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/triangle_strips.h"

namespace vfc {

void add_strip(const std::vector<std::size_t>& strip,
               std::vector<std::vector<std::size_t>>& polygons)
{
  for(std::size_t i = 2; i < strip.size(); ++i) {
    const std::size_t odd = i % 2;
    const std::size_t a = strip[i - 2 + odd], b = strip[i - 1 - odd], c = strip[i];
    if(a != b && b != c && c != a) polygons.push_back({a, b, c});
  }
}

} // namespace vfc
