// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "fill_report.h"

#include "Session.h"
#include "containment.h"
#include "numbers.h"
#include "shape.h"
#include "untangle_report.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
using curves::Filling_status;

struct Outcome
{
  Exit_status exit_status;
  const char* name;
};

Outcome outcome(Filling_status status)
{
  switch(status) {
  case Filling_status::CONVERGED:
    return {GOAL_REACHED, "converged"};
  case Filling_status::LIMIT:
    return {LIMIT_REACHED, "limit"};
  case Filling_status::STALLED:
    return {STALLED, "stalled"};
  case Filling_status::INTERRUPTED:
    return {INTERRUPTED, "interrupted"};
  }
  return {FAILURE, "error"};
}

} // namespace

Exit_status exit_status(Filling_status status)
{
  return outcome(status).exit_status;
}

void report_filling(Report& report,
                    const Curve& curve,
                    const Domain& domain,
                    const Filling_result& result)
{
  report_shape(report, curve, result.thickness);
  report_work(report, result.statistics);
  report_outside_parts(report, outside_parts(curve, domain));
  report["medial_radius"] = result.medial_radius;
  report["gradient_norm"] = result.gradient_norm;
  report["status"] = outcome(result.status).name;
}

std::string summary(const Session& session, const Curve& curve, const Filling_result& result)
{
  return std::string(outcome(result.status).name) + " after " +
         std::to_string(result.statistics.iterations) + " iterations, " +
         to_text(session.seconds()) + " s: nodes " + std::to_string(curve.number_of_nodes()) +
         ", length " + to_text(curves::length(curve)) + ", thickness " + to_text(result.thickness) +
         ", medial radius " + to_text(result.medial_radius) + ", empty regions " +
         std::to_string(result.empty_regions.size()) + '\n';
}

} // namespace vfc
