// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_KNOT_REPORT_H
#define VFC_KNOT_REPORT_H

#include "files/curve_files.h"
#include "reports/Report.h"

#include <CGAL/Volume_filling_curves/knot_diagram.h>

#include <functional>

namespace vfc {

using Progress_function = std::function<bool(const CGAL::Volume_filling_curves::Run_progress&)>;

// Diagram of closed curves, first simplified as polygons.
CGAL::Volume_filling_curves::Planar_diagram diagram_of(Curve curve,
                                                       const Progress_function& progress);

// Crossings, invariants, and what they prove.
void report_diagram(Report& report, const CGAL::Volume_filling_curves::Planar_diagram& diagram);

// Key "knottedness" of the result of a run, if the curves are closed.
void report_knottedness(Report& report, const Curve& curve, const Progress_function& progress);

} // namespace vfc

#endif // VFC_KNOT_REPORT_H
