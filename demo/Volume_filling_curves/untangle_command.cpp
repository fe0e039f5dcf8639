// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc untangle: brings a knot or link to its simplest shape by certified motion.

#include "Command_line.h"
#include "Flow_observer.h"
#include "Untangle_options.h"
#include "certificates.h"
#include "commands.h"
#include "curve_map.h"
#include "flow_named_parameters.h"
#include "interruption.h"
#include "numbers.h"
#include "pins.h"
#include "shape.h"
#include "thickness.h"
#include "untangle_report.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/Medial_thickness.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Recording.h>
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
using curves::Untangling_strategy;
using Recording = curves::internal::Recording<Curve::Traits>;

void plan_outputs(Output_files& outputs, const Untangle_options& options)
{
  add_curve_file(outputs, "--output", options.output);
  outputs.add("--certificate", options.certificate);
  outputs.add("--map", options.film.map);
  outputs.add_folder("--frames", options.film.frames, Frames::is_frame);
}

void pin(Curve& curve, const Untangle_options& options)
{
  pin_nodes(curve, options.curve);
  if(!options.keeps_length) return;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.is_pinned(v))
      throw Usage_error("--keep-length: node " + std::to_string(curve.origin(v) + 1) +
                        " is pinned, so the result cannot be scaled");
}

// The one that was asked for, if it makes sense, or the default.
// 0 where it is measured later, after a search; only a small spacing can ask for too many nodes then
double thickness(const Curve& curve, const Untangle_options& untangle_options)
{
  constexpr double harmless_spacing = 0.01;
  const Flow_options& options = untangle_options.flow;
  const double asked = options.parameters.thickness, spacing = options.parameters.spacing;
  check_thickness(asked, spacing, curve);
  const bool is_flow = untangle_options.strategy() == Untangling_strategy::FLOW;
  if(asked > 0 || (!is_flow && spacing >= harmless_spacing)) return asked;
  using Thickness = curves::internal::Medial_thickness<Curve, CGAL::Parallel_if_available_tag>;
  const double found = Thickness(curve, options.parameters.number_of_directions)();
  check_thickness(found, spacing, curve);
  return is_flow ? found : asked;
}

Untangling_result untangle(Curve& curve, const Untangle_options& options, Flow_observer& observer)
{
  return curves::untangle<CGAL::Parallel_if_available_tag>(
      curve, flow_named_parameters(options.flow, options.stop)
                 .thickness(thickness(curve, options))
                 .tolerance(options.stop.tolerance)
                 .stop_at_proof(!options.finishes)
                 .keep_length(options.keeps_length)
                 .strategy(options.strategy())
                 .number_of_chains(options.number_of_chains)
                 .random_seed(options.seed)
                 .visitor(std::ref(observer)));
}

void write_files(Session& session,
                 const Untangle_options& options,
                 const Curve& curve,
                 const Recording& recording)
{
  if(!options.output.empty()) write_curve(options.output, curve);
  if(!options.certificate.empty()) write_certificate(options.certificate, recording.certificate());
  write_map(options.film.map, options.output, curve);
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
  session.add_input(options.file, "--output");
  plan_outputs(session.outputs(), options);
  poll_interruptions();
  Curve curve = read_curve(session, options.file, options.curve.is_network);
  const double length = curves::length(curve);
  pin(curve, options);
  const Recording recording(curve, !options.certificate.empty());
  Untangling_result result;
  {
    Flow_observer observer(session, options.stop, Frames(options.film.frames, options.film.every));
    result = untangle(curve, options, observer);
  }
  check_length(session, options, curve, length);
  report_stages(session, result.statistics);
  write_files(session, options, curve, recording);
  if(session.has_report()) report_shape(session.report(), curve, result.thickness);
  session.end_stage("measuring");
  report_run(session.report(), result, options.strategy());
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
      "passes through itself. Curves with pinned ends only flow. SIGINT and SIGTERM stop the run "
      "and\n"
      "write the curve as it is; a second one ends at once.\n"
      "Exit status: 0 unknotted or converged, 2 a limit was reached, 3 stalled, 5 interrupted.");
}

} // namespace vfc
