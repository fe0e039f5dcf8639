// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CONTAINMENT_H
#define VFC_CONTAINMENT_H

#include "curve_files.h"
#include "mesh_files.h"

#include <cstddef>
#include <string>
#include <vector>

namespace vfc {

class Report;

// What of a curve is not strictly inside of a domain; decided exactly.
struct Outside_parts
{
  std::vector<std::size_t> nodes;
  std::vector<std::size_t> edges; // with any point on or beyond the surface
};

Outside_parts outside_parts(const Curve& curve, const Domain& domain);

void report_outside_parts(Report& report, const Outside_parts& outside);

// An error for each, and for too many of them the total.
Defects to_defects(const Outside_parts& outside, const Curve& curve, const std::string& file);

} // namespace vfc

#endif // VFC_CONTAINMENT_H
