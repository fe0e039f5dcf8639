// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc untangle: brings a knot or link to its simplest shape by certified motion.

#include "Command_line.h"
#include "Flow_observer.h"
#include "Untangle_options.h"
#include "commands.h"
#include "interruption.h"
#include "numbers.h"
#include "pins.h"
#include "shape.h"
#include "untangle_report.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
using curves::Untangling_result;

void plan_outputs(Output_files& outputs, const Untangle_options& options)
{
  add_curve_file(outputs, "--output", options.output);
  outputs.add("--map", options.map);
  outputs.add_folder("--frames", options.frames);
}

void pin(Curve& curve, const Untangle_options& options)
{
  pin_nodes(curve, options.pin);
  if(!options.has_free_ends) curve.pin_ends();
  if(!options.keeps_length) return;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.is_pinned(v))
      throw Usage_error("--keep-length: node " + std::to_string(curve.origin(v) + 1) +
                        " is pinned, so the result cannot be scaled");
}

// A slip of the pen must not fill the memory.
void check_thickness(const Curve& curve, const Untangle_options& options)
{
  constexpr double most_nodes = 2e7; // some 20 GB
  const double spacing = options.flow.spacing * options.flow.thickness;
  if(options.flow.thickness > 0 && curves::length(curve) / spacing > most_nodes)
    throw Usage_error("--thickness " + to_text(options.flow.thickness) + " and --spacing " +
                      to_text(options.flow.spacing) + " are too small for a curve of length " +
                      to_text(curves::length(curve)) + ": there would be more than " +
                      to_text(most_nodes) + " nodes");
}

Untangling_result untangle(Curve& curve, const Untangle_options& options, Flow_observer& observer)
{
  return curves::untangle<CGAL::Parallel_if_available_tag>(
      curve, curves::parameters::thickness(options.flow.thickness)
                 .number_of_directions(options.flow.number_of_directions)
                 .max_radius(options.flow.max_radius)
                 .spacing(options.flow.spacing)
                 .screening(options.flow.screening)
                 .coupling(options.flow.coupling)
                 .preconditioner(options.preconditioner())
                 .time_step(options.flow.time_step)
                 .tolerance(options.stop.tolerance)
                 .number_of_iterations(options.stop.max_iterations)
                 .time_limit(options.stop.time_limit)
                 .stop_at_proof(!options.finishes)
                 .keep_length(options.keeps_length)
                 .visitor(std::ref(observer)));
}

void write_map(const Untangle_options& options, const Curve& curve)
{
  if(options.map.empty()) return;
  std::string text;
  for(const std::size_t v : nodes_in_file_order(options.output, curve)) {
    const std::size_t origin = curve.origin(v);
    text += std::to_string(origin == Curve::null_node() ? 0 : origin + 1) + '\n';
  }
  Output_files::write(options.map, text);
}

void write_files(Session& session, const Untangle_options& options, const Curve& curve)
{
  if(!options.output.empty()) write_curve(options.output, curve);
  write_map(options, curve);
  session.end_stage("writing");
}

// Strands that are in the way of the scaling end it early.
void check_length(const Session& session,
                  const Untangle_options& options,
                  const Curve& curve,
                  double wanted)
{
  constexpr double precision = 1e-9;
  const double length = curves::length(curve);
  if(options.keeps_length && std::abs(length - wanted) > precision * wanted)
    session.console().warn("--keep-length: the length is " + to_text(length) + " instead of " +
                           to_text(wanted));
}

int run(Session& session, const Untangle_options& options)
{
  session.report()["seed"] = options.seed;
  plan_outputs(session.outputs(), options);
  poll_interruptions();
  Curve curve = read_curve(session, options.file, options.is_network);
  const double length = curves::length(curve);
  pin(curve, options);
  check_thickness(curve, options);
  Untangling_result result;
  {
    Flow_observer observer(session, options.stop, Frames(options.frames, options.every));
    result = untangle(curve, options, observer);
  }
  check_length(session, options, curve, length);
  report_stages(session, result.statistics);
  write_files(session, options, curve);
  if(session.has_report()) report_shape(session.report(), curve, result.thickness);
  session.end_stage("measuring");
  report_run(session.report(), result);
  session.print_summary(summary(session, curve, result));
  return exit_status(result.status);
}

} // namespace

void add_untangle_command(Command_line& command_line)
{
  const auto options = std::make_shared<Untangle_options>();
  CLI::App& command = command_line.add_command(
      "untangle", "bring a knot or link to its simplest shape by certified motion",
      [options](Session& session) { return run(session, *options); });
  add_untangle_options(command, *options);
  command.footer(
      "The curve moves until it is proved to be unknotted, or is tight, or gets nowhere; it never\n"
      "passes through itself. SIGINT and SIGTERM stop the run and write the curve as it is; a\n"
      "second one ends at once.\n"
      "Exit status: 0 unknotted or converged, 2 a limit was reached, 3 stalled, 5 interrupted.");
}

} // namespace vfc
