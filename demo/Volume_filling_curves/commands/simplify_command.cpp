// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc simplify: removes every node that can be removed.

#include "commands/commands.h"
#include "files/certificates.h"
#include "files/curve_files.h"
#include "options/Command_line.h"
#include "options/numbers.h"
#include "options/option_kinds.h"
#include "options/pins.h"
#include "options/shared_options.h"
#include "reports/shape.h"
#include "session/Exit_status.h"
#include "session/Patience.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/simplify_curves.h>

#include <memory>
#include <string>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

struct Simplify_options
{
  std::string file, output, certificate, map;
  curves::Simplification_parameters parameters;
  Curve_options curve;
};

void plan_outputs(Session& session, const Simplify_options& options)
{
  session.report()["input"] = options.file;
  session.add_input(options.file, "--output");
  add_curve_file(session.outputs(), "--output", options.output);
  session.outputs().add("--certificate", options.certificate);
  session.outputs().add("--map", options.map);
  session.require_output();
}

std::string summary(const Report& report)
{
  return "nodes " + report["nodes_start"].dump() + " -> " + report["nodes_end"].dump() +
         ", length " + to_text(report["length_start"]) + " -> " + to_text(report["length_end"]) +
         '\n';
}

int run(Session& session, const Simplify_options& options)
{
  plan_outputs(session, options);
  Curve curve = read_curve(session, options.file, options.curve.reading);
  pin_nodes(curve, options.curve);
  curves::Isotopy_certificate certificate;
  Report& report = session.report();
  curves::Simplification_parameters parameters = options.parameters;
  if(!options.certificate.empty()) parameters.certificate = &certificate;
  bool is_interrupted = false;
  parameters.progress = [&](const curves::Run_progress& progress) {
    is_interrupted = !is_to_go_on(progress);
    return !is_interrupted;
  };
  poll_interruptions();
  report["removed_nodes"] = curves::simplify_curves(curve, parameters);
  session.end_stage("simplifying");
  // the certificate first: no curve comes out of a run that was to be certified without one
  if(!options.certificate.empty()) write_certificate(options.certificate, certificate);
  if(!options.output.empty()) write_curve(options.output, curve);
  write_map(options.map, options.output, curve);
  session.end_stage("writing");
  if(session.has_report()) report_shape(report, curve, 0, Patience());
  report["nodes_end"] = curve.number_of_nodes();
  report["length_end"] = curves::length(curve);
  report["status"] = is_interrupted ? "interrupted" : "done";
  session.print_summary((is_interrupted ? "interrupted: " : "") + summary(report));
  return is_interrupted ? INTERRUPTED : GOAL_REACHED;
}

} // namespace

void add_simplify_command(Command_line& command_line)
{
  const auto options = std::make_shared<Simplify_options>();
  CLI::App& command =
      command_line.add_command("simplify", "remove every node that can be removed",
                               [options](Session& session) { return run(session, *options); });
  add_curve(command, options->file);
  add_curve_output(command, options->output);
  add_file(command, "--certificate", options->certificate,
           "record of all certified changes, for vfc check --certificate");
  add_file(command, "--map", options->map,
           "for each node of the result, a line with its number in CURVE");
  add_number(command, "--max-distance", options->parameters.max_distance,
             "largest distance of the result from the input, in the input's unit; default: none",
             not_negative)
      .type_name("D");
  add_number(command, "--clearance", options->parameters.clearance,
             "no removal brings edges without a common node nearer than that, in the input's unit, "
             "unless it leaves at least half of their distance",
             not_negative)
      .capture_default_str()
      ->type_name("C");
  add_curve_options(command, options->curve);
  add_batch_options(command, *command.get_option("CURVE"),
                    {&options->file, &options->output, {&options->certificate, &options->map}},
                    command_line);
  command.footer(
      "Ends, junctions and pinned nodes stay. The result is the same knot or link: every\n"
      "removal is certified.");
}

} // namespace vfc
