// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_UNTANGLE_REPORT_H
#define VFC_UNTANGLE_REPORT_H

#include "files/curve_files.h"
#include "session/Exit_status.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <string>

namespace vfc {

class Report;
class Session;

// The outcome of vfc untangle: its exit status, its part of the report, and its summary.

Exit_status exit_status(CGAL::Volume_filling_curves::Untangling_status status);

// Reports the stages of the flow, and the remaining time since the last stage.
void report_stages(Session& session,
                   const CGAL::Volume_filling_curves::Curve_flow_statistics& statistics);

// Reports the numbers of certified and refused changes.
void report_work(Report& report, const CGAL::Volume_filling_curves::Curve_flow_statistics& work);

void report_run(Report& report,
                const Curve& curve,
                const CGAL::Volume_filling_curves::Untangling_result& result,
                CGAL::Volume_filling_curves::Untangling_strategy strategy);

std::string summary(Session& session,
                    const Curve& curve,
                    const CGAL::Volume_filling_curves::Untangling_result& result);

} // namespace vfc

#endif // VFC_UNTANGLE_REPORT_H
