// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "untangle_report.h"

#include "Session.h"
#include "numbers.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;
using curves::Untangling_result;
using curves::Untangling_status;

namespace {

struct Outcome
{
  Exit_status exit_status;
  const char* name;
};

Outcome outcome(Untangling_status status)
{
  switch(status) {
  case Untangling_status::CONVERGED:
    return {GOAL_REACHED, "converged"};
  case Untangling_status::UNKNOTTED:
    return {GOAL_REACHED, "unknotted"};
  case Untangling_status::LIMIT:
    return {LIMIT_REACHED, "limit"};
  case Untangling_status::STALLED:
    return {STALLED, "stalled"};
  case Untangling_status::INTERRUPTED:
    return {INTERRUPTED, "interrupted"};
  }
  return {FAILURE, "error"};
}

Report::Json to_json(curves::Unknot_proof proof)
{
  switch(proof) {
  case curves::Unknot_proof::EDGES:
    return "edges";
  case curves::Unknot_proof::TOTAL_CURVATURE:
    return "total_curvature";
  default:
    return nullptr;
  }
}

Report::Json to_json(curves::Link_status link)
{
  switch(link) {
  case curves::Link_status::TRIVIAL:
    return "trivial";
  case curves::Link_status::LINKED:
    return "linked";
  case curves::Link_status::UNDECIDED:
    return "undecided";
  default:
    return nullptr;
  }
}

} // namespace

Exit_status exit_status(Untangling_status status)
{
  return outcome(status).exit_status;
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
                const Untangling_result& result,
                curves::Untangling_strategy strategy)
{
  report["status"] = outcome(result.status).name;
  report["proof"] = Report::Json::array();
  for(const auto proof : result.proofs) report["proof"].push_back(to_json(proof));
  report["link"] = to_json(result.link);
  report["gradient_norm"] = result.gradient_norm;
  report_work(report, result.statistics);
  if(strategy == curves::Untangling_strategy::TIGHTEN) report["iterations"] = result.sweeps;
  report["sweeps"] = result.sweeps;
  report["tightenings"] = result.tightenings;
}

std::string summary(Session& session, const Curve& curve, const Untangling_result& result)
{
  const Report& report = session.report();
  return std::string(outcome(result.status).name) + " after " +
         std::to_string(result.statistics.iterations) + " iterations and " +
         std::to_string(result.sweeps) + " sweeps, " + to_text(session.seconds()) + " s: nodes " +
         report["nodes_start"].dump() + " -> " + std::to_string(curve.number_of_nodes()) +
         ", length " + to_text(report["length_start"]) + " -> " + to_text(curves::length(curve)) +
         ", thickness " + to_text(result.thickness) + ", gradient " +
         to_text(result.gradient_norm) + '\n';
}

} // namespace vfc
