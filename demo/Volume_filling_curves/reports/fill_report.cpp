// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/fill_report.h"

#include "options/numbers.h"
#include "reports/containment.h"
#include "reports/coverage_report.h"
#include "reports/shape.h"
#include "reports/untangle_report.h"
#include "session/Session.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;
using curves::Filling_status;

Exit_status exit_status(Filling_status status)
{
  switch(status) {
  case Filling_status::CONVERGED:
    return GOAL_REACHED;
  case Filling_status::PARTIAL:
  case Filling_status::LENGTH_NOT_REACHED:
  case Filling_status::LIMIT:
    return LIMIT_REACHED;
  case Filling_status::STALLED:
    return STALLED;
  case Filling_status::INTERRUPTED:
    return INTERRUPTED;
  }
  return FAILURE;
}

void report_filling(Report& report,
                    const Curve& curve,
                    const Domain& domain,
                    const Filling_result& result)
{
  report_shape(report, curve, result.thickness);
  report_work(report, result.statistics);
  report_containment(report, containment(curve, domain));
  report["medial_radius"] = result.medial_radius;
  report["gradient_norm"] = result.gradient_norm;
  report_coverage(report, result.coverage);
  report_unfilled(report, result.unfilled_fraction, result.empty_regions);
  report["parts"] = result.parts;
  report["unreachable_parts"] = result.unreachable_parts;
  report["thin_fraction"] = result.thickness_fit.thin_fraction;
  report["fitting_thickness"] = result.thickness_fit.fitting_thickness;
  if(!result.reason.empty()) report["reason"] = result.reason;
  report["status"] = report_name(to_string(result.status));
}

std::string summary(const Session& session, const Curve& curve, const Filling_result& result)
{
  return std::string(to_string(result.status)) + " after " +
         std::to_string(result.statistics.iterations) + " iterations, " +
         to_text(session.seconds()) + " s: nodes " + std::to_string(curve.number_of_nodes()) +
         ", length " + to_text(curves::length(curve)) + ", thickness " + to_text(result.thickness) +
         ", medial radius " + to_text(result.medial_radius) + ", within r " +
         to_text(100 * result.coverage.fraction_within_r) + " %, beyond 2 r " +
         to_text(100 * result.unfilled_fraction) + " %, empty regions " +
         std::to_string(result.empty_regions.size()) + '\n' +
         (result.reason.empty() ? "" : "not filled: " + result.reason + '\n');
}

} // namespace vfc
