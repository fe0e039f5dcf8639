// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_STRANDS_H
#define VFC_STRANDS_H

#include "files/curve_files.h"

#include <cstddef>
#include <vector>

namespace vfc {

// Part of a curve that is drawn in one go: edges, each from the end of the edge before.
struct Strand
{
  std::vector<std::size_t> edges;
  bool is_closed;
};

// Returns the components of the curve. A component with junctions is split at junctions, at ends,
// and where edges have opposite directions.
std::vector<Strand> strands_of(const Curve& curve);

bool has_junction(const Curve& curve, std::size_t component);

} // namespace vfc

#endif // VFC_STRANDS_H
