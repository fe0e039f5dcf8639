// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SHAPE_H
#define VFC_SHAPE_H

#include "files/curve_files.h"
#include "reports/Report.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <array>
#include <functional>

namespace vfc {

// Reports the measures of the final curve of a command. A thickness of 0 stands for none. Measures
// that are still missing when the progress function returns false are null.
void report_shape(
    Report& report,
    const Curve& curve,
    double thickness,
    const std::function<bool(const CGAL::Volume_filling_curves::Run_progress&)>& progress = {});

Report::Json coordinates(const Curve::Point_3& p);

// Reports the least distance between two strands, and of the curve to a mesh, with their places. A
// number that was not measured is null.
void report_strands(Report& report, double distance, const std::array<Curve::Point_3, 2>& points);
void report_wall(Report& report, double distance, const Curve::Point_3& point);

} // namespace vfc

#endif // VFC_SHAPE_H
