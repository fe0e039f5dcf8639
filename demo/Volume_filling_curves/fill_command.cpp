// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc fill: fills the inside of a closed triangle mesh with a curve.

#include "Command_line.h"
#include "Fill_options.h"
#include "Flow_observer.h"
#include "commands.h"
#include "containment.h"
#include "curve_map.h"
#include "fill_report.h"
#include "flow_named_parameters.h"
#include "interruption.h"
#include "pins.h"
#include "thickness.h"
#include "thickness_field.h"
#include "untangle_report.h"

#include <CGAL/Volume_filling_curves/fill.h>

#include <CGAL/tags.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

void plan_files(Session& session, const Fill_options& options)
{
  session.add_input(options.mesh);
  if(!options.start.empty()) session.add_input(options.start, "--output");
  if(!options.thickness_field.empty()) session.add_input(options.thickness_field);
  add_curve_file(session.outputs(), "--output", options.output);
  session.outputs().add("--map", options.film.map);
  session.outputs().add_folder("--frames", options.film.frames, Frames::is_frame);
}

// The curve to start from, empty for a circle.
Curve start(Session& session, const Fill_options& options, const Domain& domain)
{
  if(options.start.empty()) return Curve();
  Curve curve = read_curve(session, options.start, options.curve.is_network);
  session.report()["input"] = options.mesh;
  Defects outside = to_defects(outside_parts(curve, domain), curve, options.start);
  if(!outside.empty()) throw Input_error(std::move(outside), "strictly inside of " + options.mesh);
  pin_nodes(curve, options.curve);
  return curve;
}

template <typename ThicknessParameter>
Filling_result fill(Curve& curve,
                    const Domain& domain,
                    const ThicknessParameter& thickness,
                    const Fill_options& options,
                    Flow_observer& observer)
{
  return curves::fill<CGAL::Parallel_if_available_tag>(
      curve, domain,
      flow_named_parameters(options.flow, options.stop)
          .thickness(thickness)
          .length(options.length)
          .wall(options.keeps_clear_of_wall() ? curves::Wall::KEEP_CLEAR : curves::Wall::COVER)
          .random_seed(options.seed)
          .visitor(std::ref(observer)));
}

Filling_result fill(Session& session,
                    Curve& curve,
                    const Domain& domain,
                    const Thickness& field,
                    const Fill_options& options)
{
  Flow_observer observer(session, options.stop, Frames(options.film.frames, options.film.every));
  if(field) return fill(curve, domain, field, options, observer);
  return fill(curve, domain, options.flow.parameters.thickness, options, observer);
}

void note_thickness(const Session& session, const Fill_options& options, double thickness)
{
  if(options.flow.parameters.thickness == 0 && options.length == 0 &&
     options.thickness_field.empty())
    session.console().note("thickness " + to_text(thickness) +
                           ", a quarter of the radius of the widest ball inside");
}

int run(Session& session, const Fill_options& options)
{
  session.report()["input"] = options.mesh;
  session.report()["seed"] = options.seed;
  plan_files(session, options);
  poll_interruptions();
  const Mesh_and_defects mesh = read_mesh(session, options.mesh);
  check_filling(options.flow.parameters.thickness, options.length, options.flow.parameters.spacing,
                mesh.mesh);
  Thickness field;
  if(!options.thickness_field.empty())
    field = read_thickness_field(options.thickness_field, options.mesh, mesh);
  const Domain domain(mesh.mesh);
  Curve curve = start(session, options, domain);
  const Filling_result result = fill(session, curve, domain, field, options);
  note_thickness(session, options, result.thickness);
  report_stages(session, result.statistics);
  if(!options.output.empty()) write_curve(options.output, curve);
  write_map(options.film.map, options.output, curve);
  session.end_stage("writing");
  if(session.has_report()) {
    report_filling(session.report(), curve, domain, result);
    report_coverage(session.report(), curve, domain,
                    field ? field : constant_thickness(result.thickness), options.seed);
  }
  session.end_stage("measuring");
  session.print_summary(summary(session, curve, result));
  return exit_status(result.status);
}

} // namespace

void add_fill_command(Command_line& command_line)
{
  const auto options = std::make_shared<Fill_options>();
  CLI::App& command =
      command_line.add_command("fill", "fill the inside of a closed triangle mesh with a curve",
                               [options](Session& session) { return run(session, *options); });
  add_fill_options(command, *options);
  command.footer(
      "The curve grows until nearly all of the inside is within r of it; it never leaves MESH and\n"
      "never passes through itself. SIGINT and SIGTERM stop the run and write the curve as it is; "
      "a\n"
      "second one ends at once.\n"
      "Exit status: 0 converged, 2 a limit was reached, 3 stalled, 5 interrupted.");
}

} // namespace vfc
