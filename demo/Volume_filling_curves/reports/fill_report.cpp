// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/fill_report.h"

#include "files/polygon_files.h"
#include "options/numbers.h"
#include "reports/containment.h"
#include "reports/coverage_report.h"
#include "reports/shape.h"
#include "reports/untangle_report.h"
#include "session/Patience.h"
#include "session/Session.h"

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <cmath>
#include <cstddef>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;
using curves::Filling_status;

namespace {

std::string percent(double share)
{
  return std::isfinite(share) ? to_text(100 * share) + " %" : "-"; // no time to measure it
}

std::string length_text(double length)
{
  return std::isfinite(length) ? to_text(length) : "-";
}

// The share of the whole volume, and the share without the layer to keep clear of.
std::string beyond_2r(const Filling_result& result)
{
  const double share = result.unfilled_fraction, whole = result.uncovered_fraction;
  return "beyond 2 r " + percent(whole) +
         (share < whole ? " (apart from the boundary " + percent(share) + ")" : "");
}

std::string min_distances(const Filling_result& result)
{
  return "bend radius " + length_text(result.min_bend_radius) + ", strands " +
         length_text(result.min_strand_distance) + " apart, wall " +
         length_text(result.min_wall_distance) + " away at the least; nearer than r " +
         percent(result.crowded_fraction) + " of the length\n";
}

} // namespace

Exit_status exit_status(Filling_status status)
{
  switch(status) {
  case Filling_status::CONVERGED:
    return GOAL_REACHED;
  case Filling_status::PARTIAL:
  case Filling_status::LENGTH_NOT_REACHED:
  case Filling_status::CONSTRAINT_NOT_REACHED:
  case Filling_status::LIMIT:
    return LIMIT_REACHED;
  case Filling_status::STALLED:
    return STALLED;
  case Filling_status::INTERRUPTED:
    return INTERRUPTED;
  }
  return FAILURE;
}

namespace {

template <typename Domain>
void report_measures(Report& report,
                     const Curve& curve,
                     const Domain& domain,
                     const Filling_result& result,
                     bool is_out_of_time)
{
  const bool is_hurried = is_out_of_time || result.status == Filling_status::INTERRUPTED;
  const Patience patience = is_hurried ? Patience(0) : Patience();
  report_shape(report, curve, result.thickness, patience);
  try {
    report_containment(report, containment(curve, domain, curves::parameters::progress(patience)));
  } catch(const curves::Run_interrupted&) {
    report["outside_nodes"] = report["outside_segments"] = nullptr;
  }
}

void report_necks(Report& report, const Filling_result& result)
{
  if(result.necks.empty()) return;
  Report::Json& list = report["ports"] = Report::Json::array();
  for(const auto& neck : result.necks)
    list.push_back({{"point", {neck.wall.x(), neck.wall.y(), neck.wall.z()}},
                    {"direction", neck.direction},
                    {"neck", neck.length},
                    {"is_free", neck.is_free}});
}

// The lengths of the necks, and which are not free.
std::string text_of_necks(const Filling_result& result)
{
  std::string text;
  for(const auto& neck : result.necks)
    text += (text.empty() ? "necks: " : ", ") + to_text(neck.length) +
            (neck.is_free ? "" : " (a strand passes before it)");
  return text.empty() ? text : text + '\n';
}

} // namespace

template <typename Domain>
void report_filling(Report& report,
                    const Curve& curve,
                    const Domain& domain,
                    const Filling_result& result,
                    bool is_out_of_time)
{
  report_strands(report, result.min_strand_distance, result.closest_points);
  report["crowded_fraction"] = result.crowded_fraction;
  report_measures(report, curve, domain, result, is_out_of_time);
  report_work(report, result.statistics);
  report["medial_radius"] = result.medial_radius;
  report["gradient_norm"] = result.gradient_norm;
  report_coverage(report, result.coverage);
  report_wall(report, result.min_wall_distance, result.point_nearest_to_wall);
  report["unfilled_fraction"] = result.unfilled_fraction;
  report["uncovered_fraction"] = result.uncovered_fraction;
  if(result.are_empty_regions_known) report_empty_regions(report, result.empty_regions);
  report_necks(report, result);
  report["parts"] = result.parts;
  report["unreachable_parts"] = result.unreachable_parts;
  report["thin_fraction"] = result.thickness_fit.thin_fraction;
  report["fitting_thickness"] = result.thickness_fit.fitting_thickness;
  if(!result.reason.empty()) report["reason"] = result.reason;
  report["status"] = report_name(to_string(result.status));
}

template void report_filling(Report&, const Curve&, const Domain&, const Filling_result&, bool);
template void report_filling(
    Report&, const Curve&, const Planar_domain&, const Filling_result&, bool);

std::string summary(const Session& session, const Curve& curve, const Filling_result& result)
{
  return std::string(to_string(result.status)) + " after " +
         counted(result.statistics.iterations, "iteration") + ", " + to_text(session.seconds()) +
         " s: nodes " + std::to_string(curve.number_of_nodes()) + ", length " +
         to_text(curves::length(curve)) + ", thickness " + to_text(result.thickness) +
         ", medial radius " + length_text(result.medial_radius) + ", within r " +
         percent(result.coverage.fraction_within_r) + ", " + beyond_2r(result) +
         ", empty regions " +
         (result.are_empty_regions_known ? std::to_string(result.empty_regions.size()) : "-") +
         '\n' + min_distances(result) + text_of_necks(result) +
         (result.reason.empty() ? "" : to_string(result.status) + (": " + result.reason) + '\n');
}

} // namespace vfc
