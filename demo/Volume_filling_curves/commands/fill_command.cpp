// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc fill: fills the inside of a closed triangle mesh with a curve.

#include "commands/commands.h"
#include "files/certificates.h"
#include "files/checkpoints.h"
#include "files/curve_map.h"
#include "options/Command_line.h"
#include "options/Fill_options.h"
#include "options/direction_field.h"
#include "options/pins.h"
#include "options/thickness.h"
#include "options/thickness_field.h"
#include "repair/read_mended_mesh.h"
#include "reports/containment.h"
#include "reports/fill_report.h"
#include "reports/untangle_report.h"
#include "session/Flow_observer.h"

#include <CGAL/Volume_filling_curves/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/alignment.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <CGAL/tags.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

// Where the circles go that a certificate starts from, empty if there are none.
std::string file_of_circles(const Fill_options& options)
{
  const bool is_needed = !options.certificate.empty() && options.start.empty();
  return is_needed ? options.certificate + ".start.obj" : "";
}

void plan_files(Session& session, const Fill_options& options)
{
  session.add_input(options.mesh);
  if(!options.start.empty()) session.add_input(options.start, "--output");
  if(!options.thickness_field.empty()) session.add_input(options.thickness_field);
  if(!options.direction_field.empty() && !is_vector(options.direction_field))
    session.add_input(options.direction_field);
  add_curve_file(session.outputs(), "--output", options.output);
  session.outputs().add("--certificate", options.certificate);
  session.outputs().add("--certificate", file_of_circles(options));
  session.outputs().add("--map", options.film.map);
  session.outputs().add_folder("--frames", options.film.frames, Frames::is_frame);
  plan_checkpoints(session, options.saving);
}

// The curve to start from, empty for circles.
Curve start(Session& session, const Fill_options& options, const Domain& domain)
{
  if(options.start.empty()) return Curve();
  Curve curve = read_curve(session, options.start, options.curve.is_network);
  session.report()["input"] = options.mesh;
  Defects outside = to_defects(containment(curve, domain), curve, options.start);
  if(!outside.empty()) throw Input_error(std::move(outside), "strictly inside of " + options.mesh);
  pin_nodes(curve, options.curve);
  return curve;
}

Filling_result fill(Session& session,
                    Curve& curve,
                    const Domain& domain,
                    const Thickness& field,
                    const Direction_field& directions,
                    const Fill_options& options,
                    const curves::Run_state& state,
                    curves::Isotopy_certificate& certificate)
{
  Flow_observer observer(session, options.parameters, 0, Frames(options.film));
  curves::Filling_parameters<> parameters = options.parameters;
  parameters.thickness_field = field;
  parameters.direction_field = directions;
  if(!options.certificate.empty()) parameters.certificate = &certificate;
  parameters.resume_from = &state;
  save_states(session, parameters, options.saving);
  Filling_result result = resume(options.saving, [&] {
    return curves::fill<CGAL::Parallel_if_available_tag>(curve, domain, parameters,
                                                         std::ref(observer));
  });
  observer.finish();
  return result;
}

void note_thickness(const Session& session, const Fill_options& options, double thickness)
{
  if(options.parameters.thickness == 0 && options.parameters.length == 0 &&
     options.thickness_field.empty())
    session.console().note("thickness " + to_text(thickness) +
                           ", a quarter of the radius of the widest ball inside");
}

int run(Session& session, const Fill_options& options)
{
  session.report()["input"] = options.mesh;
  session.report()["seed"] = options.parameters.random_seed;
  plan_files(session, options);
  const curves::Run_state state = read_run_state(options.saving);
  const Mesh_and_defects mesh = options.may_repair ? read_mended_mesh(session, options.mesh)
                                                   : read_mesh(session, options.mesh);
  check_filling(options.parameters.thickness, options.parameters.length, options.parameters.spacing,
                mesh.mesh);
  Thickness field;
  if(!options.thickness_field.empty()) field = read_thickness_field(options.thickness_field, mesh);
  Direction_field directions;
  if(!options.direction_field.empty())
    directions = make_direction_field(options.direction_field, mesh);
  const Domain domain(mesh.mesh);
  Curve curve = start(session, options, domain);
  curves::Isotopy_certificate certificate;
  const Filling_result result =
      fill(session, curve, domain, field, directions, options, state, certificate);
  note_thickness(session, options, result.thickness);
  report_stages(session, result.statistics);
  // the certificate first: no curve comes out of a run that was to be certified without one
  if(!options.certificate.empty()) write_certificate(options.certificate, certificate);
  if(!file_of_circles(options).empty()) write_curve(file_of_circles(options), Curve(result.start));
  if(!options.output.empty()) write_curve(options.output, curve, result.thickness);
  write_map(options.film.map, options.output, curve);
  session.end_stage("writing");
  if(session.has_report()) report_filling(session.report(), curve, domain, result);
  if(directions) session.report()["alignment"] = curves::alignment(curve, directions);
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
  add_batch_options(command, *command.get_option("MESH"),
                    {&options->mesh,
                     &options->output,
                     {&options->certificate, &options->film.map, &options->film.frames}},
                    command_line);
  command.footer(
      "The curve grows until nearly all of the inside is within r of it; it never leaves MESH and\n"
      "never passes through itself. SIGINT and SIGTERM stop the run and write the curve as it is; "
      "a\n"
      "second one ends at once.\n"
      "Each connected part of the inside that is wide enough gets a curve of its own, unless\n"
      "--curve is given. If more than 1 % of the inside ends farther than 2 r from the curve, the\n"
      "status is partial, and the last line says why.\n"
      "Exit status: 0 converged, 2 partial, a limit was reached, or not the length, 3 stalled,\n"
      "5 interrupted.");
}

} // namespace vfc
