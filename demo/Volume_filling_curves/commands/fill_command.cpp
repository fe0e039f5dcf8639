// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc fill: fills the inside of a closed triangle mesh, or polygons in the plane, with a curve.

#include "commands/commands.h"
#include "commands/filling_steps.h"
#include "files/certificates.h"
#include "files/checkpoints.h"
#include "files/curve_files.h"
#include "files/polygon_files.h"
#include "meshes/mesh_to_text.h"
#include "options/Command_line.h"
#include "options/Fill_options.h"
#include "options/ports.h"
#include "options/thickness.h"
#include "options/vertex_fields.h"
#include "repair/obstacles.h"
#include "repair/read_mended_mesh.h"
#include "session/Patience.h"
#include "symmetry/images.h"
#include "symmetry/sector.h"

#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

// The certificate, and the files beside it whose content no other file has.
// Other names are empty.
Certificate_files files_of_certificate(const Fill_options& options)
{
  Certificate_files files;
  files.certificate = options.certificate;
  if(options.certificate.empty()) return files;
  if(options.start.empty()) files.start = options.certificate + ".start.obj";
  if(options.symmetry.empty()) return files;
  files.end = options.certificate + ".end.obj";
  files.domain = options.certificate + ".domain.off";
  return files;
}

void plan_files(Session& session, const Fill_options& options)
{
  session.add_input(options.mesh);
  for(const std::string& obstacle : options.obstacles) session.add_input(obstacle);
  if(!options.start.empty()) session.add_input(options.start, "--output");
  if(!options.thickness_field.empty()) session.add_input(options.thickness_field);
  if(!options.direction_field.empty() && !is_vector(options.direction_field))
    session.add_input(options.direction_field);
  if(filling::is_svg(options))
    session.outputs().add("--output", options.output);
  else
    add_curve_file(session.outputs(), "--output", options.output);
  const Certificate_files files = files_of_certificate(options);
  for(const std::string& file : {files.certificate, files.start, files.end, files.domain})
    session.outputs().add("--certificate", file);
  session.outputs().add("--map", options.film.map);
  plan_checkpoints(session, options.saving);
  session.outputs().add_folder("--frames", options.film.frames, Frames::is_frame);
  session.require_output();
}

// Writes the certificate before the curve, so that no curve is left without the certificate that
// was asked for.
void write_certificate_and_start(const Fill_options& options,
                                 const curves::Isotopy_certificate& certificate,
                                 const Filling_result& result)
{
  if(options.certificate.empty()) return;
  write_certificate(options.certificate, certificate);
  const std::string start = files_of_certificate(options).start;
  if(!start.empty()) write_curve(start, Curve(result.start));
}

template <typename Domain>
int fill_domain(Session& session,
                const Domain& domain,
                const Thickness& field,
                const Direction_field& directions,
                const Fill_options& options,
                const curves::Run_state& state)
{
  Curve curve = filling::start(session, options, domain);
  curves::Isotopy_certificate certificate;
  poll_interruptions();
  const Filling_result result =
      filling::fill(session, curve, domain, field, directions, options, state, certificate);
  write_certificate_and_start(options, certificate, result);
  filling::write(session, options, curve, result);
  return filling::report(session, options, curve, domain, directions, result);
}

// Returns the curve of an arc and its images. If they do not fit, writes the arc alone, which is
// certified and may have taken long, and throws.
Curve closed_up_or_arc_written(const Session& session,
                               const Fill_options& options,
                               const Curve& arc,
                               double thickness,
                               const Ports& ports,
                               const Symmetry& symmetry,
                               const Domain& domain)
{
  try {
    return closed_up(arc, ports, symmetry, domain, options.mesh);
  } catch(const std::exception&) {
    try {
      filling::write_result(options, arc, thickness);
      if(!options.output.empty())
        session.console().warn(options.output +
                               ": holds the arc in its sector, without its images");
    } catch(const Usage_error& error) { // less important than why there are no images
      session.console().warn(error.what());
    }
    throw;
  }
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
  const std::string name = options.mesh + (options.obstacles.empty() ? "" : " with its obstacles");
  const Sector sector = sector_of(walls, whole, symmetry, options.parameters, name);
  Fill_options of_sector = options;
  of_sector.parameters.ports = sector.ports;
  of_sector.parameters.wall_distance = sector.wall_distance;
  Curve arc;
  curves::Isotopy_certificate certificate;
  poll_interruptions();
  Filling_result result = filling::fill(session, arc, Domain(sector.mesh), {}, directions,
                                        of_sector, state, certificate);
  write_certificate_and_start(options, certificate, result);
  if(!options.certificate.empty()) {
    const Certificate_files files = files_of_certificate(options);
    write_curve(files.end, arc);
    Output_files::write(files.domain, to_text(sector.mesh, ".off"));
  }
  const Curve curve = closed_up_or_arc_written(session, options, arc, result.thickness,
                                               sector.ports, symmetry, whole);
  filling::write(session, options, curve, result); // before measuring, which may be interrupted
  const Patience patience((std::max)(0., options.parameters.time_limit - session.seconds()));
  measure_again(result, curve, whole, options.parameters, patience);
  return filling::report(session, options, curve, whole, directions, result);
}

// Refuses the options that need a mesh.
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

// Reads the mesh; mending it counts against the time limit.
Mesh_and_defects mesh_of(Session& session, const Fill_options& options)
{
  if(!options.may_repair) return read_mesh(session, options.mesh);
  return read_mended_mesh(session, options.mesh, {0, options.parameters.time_limit});
}

int fill_mesh(Session& session, const Fill_options& options, const curves::Run_state& state)
{
  const Mesh_and_defects mesh = mesh_of(session, options);
  check_filling(options.parameters, mesh.mesh);
  Thickness field;
  if(!options.thickness_field.empty()) field = read_thickness_field(options.thickness_field, mesh);
  Direction_field directions;
  if(!options.direction_field.empty())
    directions = make_direction_field(options.direction_field, mesh);
  Mesh walls = mesh.mesh;
  if(options.may_repair)
    add_or_cut_out_obstacles(session, walls, options.obstacles, options.parameters.time_limit);
  else
    add_obstacles(session, walls, options.obstacles);
  if(!options.symmetry.empty()) return fill_sector(session, walls, directions, options, state);
  return fill_domain(session, Domain(walls, examined), field, directions, options, state);
}

int run(Session& session, const Fill_options& options)
{
  session.report()["input"] = options.mesh;
  session.report()["seed"] = options.parameters.random_seed;
  plan_files(session, options);
  read_ports(options.ports); // complains before any work starts
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
                     [options] {
                       const Certificate_files files = files_of_certificate(*options);
                       return std::vector{files.start, files.end, files.domain};
                     }},
                    command_line);
  command.footer(
      "About 93 % of the inside ends within r of the curve, with --preview 80 %, and 99 %\n"
      "within 1.5 r. The curve never leaves MESH and never passes through itself. SIGINT and\n"
      "SIGTERM stop the run and write the current curve; a second signal ends the program.\n"
      "If MESH is a .wkt file, with POLYGON or MULTIPOLYGON, the curve lies in the plane z = 0,\n"
      "exactly; then -o OUT.svg writes it at true scale, with a millimeter as unit.\n"
      "Each connected part of the inside that is wide enough gets its own curve, unless\n"
      "--curve, --port or --symmetry is given. If more than 1 % of the inside ends farther than\n"
      "2 r from the curve, or another strand is nearer than r along more than 5 % of its length,\n"
      "the status is partial, and the last line gives the reason.\n"
      "Exit status: 0 converged, 2 partial, limit reached, or length or constraint not reached,\n"
      "3 stalled, 5 interrupted.");
}

} // namespace vfc
