// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TRIANGLE_STRIPS_H
#define VFC_TRIANGLE_STRIPS_H

#include "formats/readers.h"

#include <cstddef>
#include <vector>

namespace vfc {

// Adds the triangles of a strip: each point forms one with its two predecessors, and every second
// one is reversed. Triangles with a repeated corner, which only continue the strip elsewhere, are
// left out.
inline void add_strip(const std::vector<std::size_t>& strip, Polygons& polygons)
{
  for(std::size_t i = 2; i < strip.size(); ++i) {
    const std::size_t odd = i % 2;
    const std::size_t a = strip[i - 2 + odd], b = strip[i - 1 - odd], c = strip[i];
    if(a != b && b != c && c != a) polygons.push_back({a, b, c});
  }
}

} // namespace vfc

#endif // VFC_TRIANGLE_STRIPS_H
