// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TRIANGLE_STRIPS_H
#define VFC_TRIANGLE_STRIPS_H

#include <cstddef>
#include <vector>

namespace vfc {

// Adds the triangles of a strip: each point makes one with the two before it, and every second is
// turned around. Those with a corner twice, which only lead the strip elsewhere, are left out.
void add_strip(const std::vector<std::size_t>& strip,
               std::vector<std::vector<std::size_t>>& polygons);

} // namespace vfc

#endif // VFC_TRIANGLE_STRIPS_H
