// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc fill: fills the inside of a closed triangle mesh, or polygons in the plane, with a curve.

#include "commands/commands.h"
#include "files/certificates.h"
#include "files/checkpoints.h"
#include "files/curve_files.h"
#include "files/polygon_files.h"
#include "formats/writers.h"
#include "meshes/read_mesh_soup.h"
#include "options/Command_line.h"
#include "options/Fill_options.h"
#include "options/pins.h"
#include "options/ports.h"
#include "options/thickness.h"
#include "options/vertex_fields.h"
#include "repair/obstacles.h"
#include "repair/read_mended_mesh.h"
#include "reports/containment.h"
#include "reports/fill_report.h"
#include "reports/untangle_report.h"
#include "session/Flow_observer.h"
#include "symmetry/sector.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>

#include <CGAL/tags.h>

#include <algorithm>
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

bool is_svg(const Fill_options& options)
{
  return is_polygon_file(options.mesh) && lower_case_extension(options.output) == ".svg";
}

void plan_files(Session& session, const Fill_options& options)
{
  session.add_input(options.mesh);
  for(const std::string& obstacle : options.obstacles) session.add_input(obstacle);
  if(!options.start.empty()) session.add_input(options.start, "--output");
  if(!options.thickness_field.empty()) session.add_input(options.thickness_field);
  if(!options.direction_field.empty() && !is_vector(options.direction_field))
    session.add_input(options.direction_field);
  if(is_svg(options))
    session.outputs().add("--output", options.output);
  else
    add_curve_file(session.outputs(), "--output", options.output);
  session.outputs().add("--certificate", options.certificate);
  session.outputs().add("--certificate", file_of_circles(options));
  session.outputs().add("--map", options.film.map);
  session.outputs().add_folder("--frames", options.film.frames, Frames::is_frame);
  plan_checkpoints(session, options.saving);
  session.require_output();
}

// The curve to start from, empty for circles.
template <typename Domain>
Curve start(Session& session, const Fill_options& options, const Domain& domain)
{
  if(options.start.empty()) return Curve();
  Curve curve = read_curve(session, options.start, options.curve.reading);
  session.report()["input"] = options.mesh;
  Defects outside = to_defects(containment(curve, domain), curve, options.start);
  if(!outside.empty()) throw Input_error(std::move(outside), "strictly inside of " + options.mesh);
  pin_nodes(curve, options.curve);
  return curve;
}

template <typename Domain>
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
  // the rest after reading and mending
  parameters.time_limit = (std::max)(0., parameters.time_limit - session.seconds());
  if(!options.ports.empty()) parameters.ports = read_ports(options.ports);
  parameters.volume_shares = read_volume_shares(options.volume_shares);
  parameters.thickness_field = field;
  parameters.direction_field = directions;
  if(!options.certificate.empty()) parameters.certificate = &certificate;
  parameters.resume_from = &state;
  parameters.progress = [&](const curves::Run_progress& progress) {
    return observer.on_progress(progress);
  };
  save_states(session, parameters, options.saving);
  Filling_result result = resume(options.saving, [&] {
    return curves::fill<CGAL::Parallel_if_available_tag>(curve, domain, parameters,
                                                         std::ref(observer));
  });
  observer.finish(result.statistics.iterations, curve);
  return result;
}

// States why the thickness is not the one that was asked for.
void note_thickness(const Session& session,
                    const Fill_options& options,
                    const Filling_result& result)
{
  const curves::Filling_parameters<>& asked_for = options.parameters;
  if(!options.thickness_field.empty() || asked_for.length > 0) return;
  const double least = curves::internal::min_thickness_for(asked_for);
  const auto note = [&](const std::string& reason) {
    session.console().note("thickness " + to_text(result.thickness) + ", " + reason);
  };
  if(asked_for.thickness < least && result.thickness <= least)
    note("the least that allows such bends");
  else if(asked_for.thickness == 0 && !(result.default_thickness > 0))
    note("a quarter of the radius of the widest ball inside");
}

// Reads the mesh; mending it takes its part of the time that the filling has.
Mesh_and_defects mesh_of(Session& session, const Fill_options& options)
{
  if(!options.may_repair) return read_mesh(session, options.mesh);
  return read_mended_mesh(session, options.mesh, {0, options.parameters.time_limit});
}

void write_result(const Fill_options& options, const Curve& curve, double thickness)
{
  if(options.output.empty()) return;
  if(is_svg(options))
    Output_files::write(options.output, to_svg(Curve_paths(curve)));
  else
    write_curve(options.output, curve, thickness);
}

// Writes and reports a curve that fills a domain.
template <typename Domain>
int finish(Session& session,
           const Fill_options& options,
           const Curve& curve,
           const Domain& domain,
           const Direction_field& directions,
           const Filling_result& result)
{
  note_thickness(session, options, result);
  report_stages(session, result.statistics);
  write_result(options, curve, result.thickness);
  write_map(options.film.map, options.output, curve);
  session.end_stage("writing");
  const bool is_out_of_time = session.seconds() >= options.parameters.time_limit;
  if(session.has_report()) report_filling(session.report(), curve, domain, result, is_out_of_time);
  if(directions && !is_out_of_time)
    session.report()["alignment"] = curves::alignment(curve, directions);
  session.end_stage("measuring");
  session.print_summary(summary(session, curve, result));
  return exit_status(result.status);
}

template <typename Domain>
int fill_domain(Session& session,
                const Domain& domain,
                const Thickness& field,
                const Direction_field& directions,
                const Fill_options& options,
                const curves::Run_state& state)
{
  Curve curve = start(session, options, domain);
  curves::Isotopy_certificate certificate;
  poll_interruptions();
  const Filling_result result =
      fill(session, curve, domain, field, directions, options, state, certificate);
  // the certificate first: no curve comes out of a run that was to be certified without one
  if(!options.certificate.empty()) write_certificate(options.certificate, certificate);
  if(!file_of_circles(options).empty()) write_curve(file_of_circles(options), Curve(result.start));
  return finish(session, options, curve, domain, directions, result);
}

// Fills one sector of a mesh, and closes the arc up with its images.
int fill_sector(Session& session,
                const Mesh& walls,
                const Direction_field& directions,
                const Fill_options& options,
                const curves::Run_state& state)
{
  const Domain whole(walls, examined);
  const Symmetry symmetry(options.symmetry, whole.bbox());
  const double r = options.parameters.thickness;
  const Sector sector = sector_of(walls, whole, symmetry, r, options.mesh);
  Fill_options of_sector = options;
  of_sector.parameters.ports = sector.ports;
  Curve arc;
  curves::Isotopy_certificate none;
  poll_interruptions();
  Filling_result result =
      fill(session, arc, Domain(sector.mesh), {}, directions, of_sector, state, none);
  const Curve curve = closed_up(arc, sector.ports, symmetry, whole, options.mesh);
  measure_again(result, curve, whole, options.parameters);
  return finish(session, options, curve, whole, directions, result);
}

// Options that are for meshes: files with values at their vertices, and what changes them.
void refuse_options_of_meshes(const Fill_options& options)
{
  const std::string reason = " is for meshes, but " + options.mesh + " holds polygons";
  if(options.may_repair) throw Usage_error("--repair" + reason);
  if(!options.symmetry.empty()) throw Usage_error("--symmetry" + reason);
  if(!options.obstacles.empty()) throw Usage_error("--obstacle" + reason + ", which have holes");
  if(!options.thickness_field.empty()) throw Usage_error("--thickness-field" + reason);
  if(!options.direction_field.empty() && !is_vector(options.direction_field))
    throw Usage_error("--direction-field FILE" + reason + "; give a vector x,y,z");
}

int fill_polygons(Session& session, const Fill_options& options, const curves::Run_state& state)
{
  refuse_options_of_meshes(options);
  const Planar_domain domain = *read_polygons(session, options.mesh).domain;
  Direction_field directions;
  if(!options.direction_field.empty())
    directions = make_direction_field(options.direction_field, {});
  return fill_domain(session, domain, {}, directions, options, state);
}

int fill_mesh(Session& session, const Fill_options& options, const curves::Run_state& state)
{
  const Mesh_and_defects mesh = mesh_of(session, options);
  check_filling(options.parameters.thickness, options.parameters.length, options.parameters.spacing,
                mesh.mesh);
  Thickness field;
  if(!options.thickness_field.empty()) field = read_thickness_field(options.thickness_field, mesh);
  Direction_field directions;
  if(!options.direction_field.empty())
    directions = make_direction_field(options.direction_field, mesh);
  Mesh walls = mesh.mesh;
  const auto add = options.may_repair ? add_or_cut_out_obstacles : add_obstacles;
  add(session, walls, options.obstacles);
  if(!options.symmetry.empty()) return fill_sector(session, walls, directions, options, state);
  return fill_domain(session, Domain(walls, examined), field, directions, options, state);
}

int run(Session& session, const Fill_options& options)
{
  session.report()["input"] = options.mesh;
  session.report()["seed"] = options.parameters.random_seed;
  plan_files(session, options);
  read_ports(options.ports); // these two complain before any work starts
  read_volume_shares(options.volume_shares);
  const curves::Run_state state = read_run_state(options.saving);
  return is_polygon_file(options.mesh) ? fill_polygons(session, options, state)
                                       : fill_mesh(session, options, state);
}

} // namespace

void add_fill_command(Command_line& command_line)
{
  const auto options = std::make_shared<Fill_options>();
  CLI::App& command = command_line.add_command(
      "fill", "fill the inside of a closed triangle mesh, or polygons in the plane",
      [options](Session& session) { return run(session, *options); });
  add_fill_options(command, *options);
  add_batch_options(command, *command.get_option("MESH"),
                    {&options->mesh,
                     &options->output,
                     {&options->certificate, &options->film.map, &options->film.frames},
                     [options] { return file_of_circles(*options); }},
                    command_line);
  command.footer(
      "The curve grows until about 80 % of the inside is within r of it and 99 % within 2 r; it\n"
      "never leaves MESH and never passes through itself. SIGINT and SIGTERM stop the run\n"
      "and write the current curve; a second one ends at once.\n"
      "If MESH is a .wkt file, with POLYGON or MULTIPOLYGON, the curve lies in the plane z = 0,\n"
      "exactly; then -o OUT.svg writes it at true scale, with a millimeter as unit.\n"
      "Each connected part of the inside that is wide enough gets its own curve, unless\n"
      "--curve is given. If more than 1 % of the inside ends farther than 2 r from the curve, or\n"
      "another strand is nearer than r along more than 5 % of its length, the status is partial,\n"
      "and the last line gives the reason.\n"
      "Exit status: 0 converged, 2 partial, limit reached, or length or constraint not reached,\n"
      "3 stalled, 5 interrupted.");
}

} // namespace vfc
