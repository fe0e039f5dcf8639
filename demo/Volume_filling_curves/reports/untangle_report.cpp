// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/untangle_report.h"

#include "options/numbers.h"
#include "reports/knot_report.h"
#include "session/Patience.h"
#include "session/Session.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;
using curves::Untangling_result;
using curves::Untangling_status;

namespace {

// The name of a proof or link status, or null for none.
template <typename Enum>
Report::Json name_or_null(Enum value, Enum none)
{
  if(value == none) return nullptr;
  return report_name(to_string(value));
}

bool has_ends(const Curve& curve)
{
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.degree(v) == 1) return true;
  return false;
}

bool has_free_end(const Curve& curve)
{
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.degree(v) == 1 && !curve.is_pinned(v)) return true;
  return false;
}

// Unexpected properties of the result, and their reasons.
std::string remark(const Curve& curve, const Untangling_result& result)
{
  constexpr double length_of_point = 2; // in units of the thickness
  if(has_free_end(curve) && curves::length(curve) < length_of_point * result.thickness)
    return ", free ends: nothing holds the curve, which shrinks to a point";
  if(result.fitting_thickness > 0)
    return ", the thickness is too small for this curve: try " + to_text(result.fitting_thickness);
  if(result.is_input) return ", the input, which is tighter than what was found";
  if(!result.is_closure_kept) return ", the closure of an arc is not known to have kept its type";
  const bool has_flowed = result.statistics.iterations > 0;
  if(result.status != Untangling_status::UNKNOTTED || result.is_round || !has_flowed) return {};
  if(curve.number_of_components() > 1) return ", not round: several components";
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.is_pinned(v)) return ", not round: nodes are pinned";
  return ", not round: the flow ended at the proof";
}

} // namespace

Exit_status exit_status(Untangling_status status)
{
  switch(status) {
  case Untangling_status::CONVERGED:
  case Untangling_status::UNKNOTTED:
    return GOAL_REACHED;
  case Untangling_status::CONSTRAINT_NOT_REACHED:
  case Untangling_status::LIMIT:
    return LIMIT_REACHED;
  case Untangling_status::STALLED:
    return STALLED;
  case Untangling_status::INTERRUPTED:
    return INTERRUPTED;
  }
  return FAILURE;
}

void report_stages(Session& session, const curves::Curve_flow_statistics& work)
{
  const double seconds = session.end_stage("other");
  Report::Json& stages = session.report()["seconds_by_stage"];
  stages["medial_spheres"] = work.seconds_medial_spheres;
  stages["direction"] = work.seconds_direction;
  stages["motion"] = work.seconds_motion;
  stages["remeshing"] = work.seconds_remeshing;
  stages["other"] = seconds - work.seconds_medial_spheres - work.seconds_direction -
                    work.seconds_motion - work.seconds_remeshing;
}

void report_work(Report& report, const curves::Curve_flow_statistics& work)
{
  report["iterations"] = work.iterations;
  report["moves_certified"] = work.certified_changes;
  report["moves_rejected"] = work.refused_changes;
  report["shortened_steps"] = work.shortened_steps;
  report["refused_remeshing"] = work.refused_remeshing;
}

void report_run(Report& report,
                const Curve& curve,
                const Untangling_result& result,
                curves::Untangling_strategy strategy)
{
  report["status"] = report_name(to_string(result.status));
  report["proof"] = Report::Json::array();
  for(const auto proof : result.proofs)
    report["proof"].push_back(name_or_null(proof, curves::Unknot_proof::NONE));
  report["link"] = name_or_null(result.link, curves::Link_status::NOT_A_LINK);
  constexpr double patience = 1; // seconds; 100,000 nodes take one
  if(result.status == Untangling_status::UNKNOTTED)
    report_knottedness(report, curves::Knottedness::UNKNOTTED);
  else
    report_knottedness(report, curve, Patience(patience));
  report["gradient_norm"] = result.gradient_norm;
  if(!result.shape_excesses.empty())
    report["reason"] = curves::internal::shape_reason(result.shape_excesses);
  if(result.fitting_thickness > 0) report["fitting_thickness"] = result.fitting_thickness;
  report_work(report, result.statistics);
  if(strategy == curves::Untangling_strategy::SEARCH) report["iterations"] = result.sweeps;
  report["sweeps"] = result.sweeps;
  report["tightenings"] = result.searches;
  if(result.status == Untangling_status::UNKNOTTED) report["is_round"] = result.is_round;
  report["is_ropelength_lowered"] = result.is_ropelength_lowered;
  report["is_input"] = result.is_input;
  if(has_ends(curve)) report["is_closure_kept"] = result.is_closure_kept;
}

namespace {

// What was proved of a curve that was not untied.
std::string knottedness(const Report& report)
{
  if(report["knottedness"].is_null()) return {};
  std::string text = report["knottedness"];
  std::replace(text.begin(), text.end(), '_', ' ');
  return text == to_string(curves::Knottedness::UNKNOWN) ? "" : ", " + text;
}

} // namespace

std::string summary(Session& session, const Curve& curve, const Untangling_result& result)
{
  const Report& report = session.report();
  const bool is_unknotted = result.status == Untangling_status::UNKNOTTED;
  return std::string(to_string(result.status)) + (is_unknotted ? "" : knottedness(report)) +
         " after " + counted(result.statistics.iterations, "iteration") + " and " +
         counted(result.sweeps, "sweep") + ", " + to_text(session.seconds()) + " s: nodes " +
         report["nodes_start"].dump() + " -> " + std::to_string(curve.number_of_nodes()) +
         ", length " + to_text(report["length_start"]) + " -> " + to_text(curves::length(curve)) +
         ", thickness " + (result.thickness > 0 ? to_text(result.thickness) : "unknown") +
         ", gradient " +
         (std::isnan(result.gradient_norm) ? "unknown" : to_text(result.gradient_norm)) +
         remark(curve, result) + '\n' +
         (result.shape_excesses.empty()
              ? ""
              : curves::internal::shape_reason(result.shape_excesses) + '\n');
}

} // namespace vfc
