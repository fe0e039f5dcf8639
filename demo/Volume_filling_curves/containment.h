// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CONTAINMENT_H
#define VFC_CONTAINMENT_H

#include "curve_files.h"
#include "mesh_files.h"

#include <CGAL/Volume_filling_curves/internal/outside_parts.h>

#include <string>

namespace vfc {

class Report;

using CGAL::Volume_filling_curves::internal::outside_parts;
using CGAL::Volume_filling_curves::internal::Outside_parts;

void report_outside_parts(Report& report, const Outside_parts& outside);

// An error for each, and for too many of them the total.
Defects to_defects(const Outside_parts& outside, const Curve& curve, const std::string& file);

} // namespace vfc

#endif // VFC_CONTAINMENT_H
