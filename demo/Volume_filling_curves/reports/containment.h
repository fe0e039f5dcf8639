// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CONTAINMENT_H
#define VFC_CONTAINMENT_H

#include "files/curve_files.h"
#include "files/mesh_files.h"

#include <CGAL/Volume_filling_curves/coverage.h>

#include <string>

namespace vfc {

class Report;

using CGAL::Volume_filling_curves::containment;
using CGAL::Volume_filling_curves::Containment;

void report_containment(Report& report, const Containment& found);

// An error for each, and for too many of them the total.
Defects to_defects(const Containment& found, const Curve& curve, const std::string& file);

} // namespace vfc

#endif // VFC_CONTAINMENT_H
