// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FILL_REPORT_H
#define VFC_FILL_REPORT_H

#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "session/Exit_status.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>

#include <string>

namespace vfc {

class Report;
class Session;

// The outcome of vfc fill: its exit status, its part of the report, and its summary.

using Filling_result = CGAL::Volume_filling_curves::Filling_result<Curve::Point_3>;

Exit_status exit_status(CGAL::Volume_filling_curves::Filling_status status);

// For a large curve that is out of time or was interrupted, the report has only figures known so
// far.
template <typename Domain>
void report_filling(Report& report,
                    const Curve& curve,
                    const Domain& domain,
                    const Filling_result& result,
                    bool is_out_of_time);

std::string summary(const Session& session, const Curve& curve, const Filling_result& result);

} // namespace vfc

#endif // VFC_FILL_REPORT_H
