// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc check: lists every defect of a curve or a mesh, and where a curve leaves a mesh; replays the
// record of a run.

#include "commands/commands.h"
#include "files/certificates.h"
#include "files/curve_files.h"
#include "files/polygon_files.h"
#include "options/Command_line.h"
#include "options/numbers.h"
#include "options/option_kinds.h"
#include "repair/obstacles.h"
#include "reports/containment.h"
#include "reports/shape.h"
#include "session/Exit_status.h"

#include <CGAL/Volume_filling_curves/coverage.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vfc {
namespace {

struct Check_options
{
  std::string file, mesh; // with a certificate the curves at the start and at the end
  std::string certificate, domain;
  std::vector<std::string> obstacles;
  double wall_distance = 0; // 0 for none
  Curve_reading reading;
};

template <typename Number>
Report::Json known(const Number& number)
{
  return number > 0 ? Report::Json(number) : Report::Json();
}

Report::Json to_json(const Defect& defect)
{
  return {{"kind", defect.kind},
          {"severity", defect.is_error ? "error" : "warning"},
          {"file", defect.file},
          {"line", known(defect.line)},
          {"nodes", defect.nodes},
          {"faces", defect.faces},
          {"component", known(defect.component)},
          {"message", defect.message}};
}

// Prints and reports the defects.
void list(Session& session, const Defects& defects)
{
  Report::Json& listed = session.report()["defects"] = Report::Json::array();
  for(const Defect& defect : defects) {
    session.print_result(defect.text + '\n');
    listed.push_back(to_json(defect));
  }
}

void append(Defects& defects, Defects more)
{
  std::move(more.begin(), more.end(), std::back_inserter(defects));
}

// An error if the curve, which lies inside, comes nearer to the boundary than it may.
template <typename Domain>
Defects nearer_to_wall(Report& report,
                       const Curve& curve,
                       const Domain& domain,
                       const Check_options& options)
{
  namespace curves = CGAL::Volume_filling_curves;
  const auto nearest = curves::min_wall_distance<CGAL::Parallel_if_available_tag>(curve, domain);
  report_wall(report, nearest.distance, nearest.point);
  if(nearest.distance >= options.wall_distance) return {};
  const std::size_t v = curve.source(nearest.edge), w = curve.target(nearest.edge);
  return {Defect("near wall", options.file, {curve.origin(v) + 1, curve.origin(w) + 1},
                 curve.component(v) + 1,
                 "an edge comes as near to the mesh as " + to_text(nearest.distance))};
}

Defects defects_of_curve(Session& session, const Check_options& options)
{
  Report& report = session.report();
  Curve_and_defects curve = read_curve_and_defects(options.file, options.reading);
  Defects defects = std::move(curve.defects);
  if(curve.is_valid) {
    report["components"] = curve.curve.number_of_components();
    report["nodes_start"] = curve.curve.number_of_nodes();
  }
  if(options.mesh.empty()) return defects;
  const auto find_outside = [&](const auto& domain) {
    const Containment found = containment(curve.curve, domain);
    report_containment(report, found);
    append(defects, to_defects(found, curve.curve, options.file));
    if(found.is_inside() && options.wall_distance > 0)
      append(defects, nearer_to_wall(report, curve.curve, domain, options));
  };
  if(is_polygon_file(options.mesh)) {
    Polygons_and_defects polygons = read_polygons_and_defects(options.mesh);
    append(defects, std::move(polygons.defects));
    if(curve.is_valid && polygons.domain) find_outside(*polygons.domain);
    return defects;
  }
  Mesh_and_defects mesh = read_mesh_and_defects(options.mesh);
  append(defects, std::move(mesh.defects));
  if(!curve.is_valid || !mesh.is_valid) return defects;
  for(const std::string& obstacle : options.obstacles) session.add_input(obstacle);
  add_obstacles(session, mesh.mesh, options.obstacles);
  find_outside(Domain(mesh.mesh, examined));
  return defects;
}

Defects find_defects(Session& session, const Check_options& options)
{
  const bool has_second = !options.mesh.empty();
  const bool has_domain = options.certificate.empty() ? has_second : !options.domain.empty();
  if(!options.obstacles.empty() &&
     is_polygon_file(options.certificate.empty() ? options.mesh : options.domain))
    throw Usage_error("--obstacle: is for meshes; polygons have holes");
  if(!options.obstacles.empty() && !has_domain)
    throw Usage_error("--obstacle: needs MESH, or --domain with --certificate");
  if(!options.certificate.empty()) {
    if(!has_second) throw Usage_error("--certificate: needs two curves, START and END");
    if(options.wall_distance > 0)
      throw Usage_error("--wall-distance: is for FILE MESH; a certificate records no distances");
    return defects_of_certificate(
        session,
        {options.certificate, options.file, options.mesh, options.domain, options.obstacles},
        options.reading);
  }
  if(options.wall_distance > 0 && !has_second)
    throw Usage_error("--wall-distance: is for FILE MESH");
  if(!options.domain.empty())
    throw Usage_error("--domain: needs --certificate; to check a curve use FILE MESH");
  const bool is_polygons = is_polygon_file(options.file), is_mesh = is_mesh_file(options.file);
  if((is_polygons || is_mesh) && has_second)
    throw Usage_error("FILE: " + options.file + (is_mesh ? ": is a surface" : ": holds polygons") +
                      ", but " + options.mesh + " takes a curve to check");
  if(is_polygons) return read_polygons_and_defects(options.file).defects;
  return is_mesh ? read_mesh_and_defects(options.file).defects : defects_of_curve(session, options);
}

int check(Session& session, const Check_options& options)
{
  Report& report = session.report();
  report["input"] = options.file;
  session.add_input(options.file);
  if(!options.mesh.empty()) session.add_input(options.mesh);
  Defects defects = find_defects(session, options);
  session.end_stage("checking");
  list(session, defects);
  const auto errors = std::count_if(defects.begin(), defects.end(),
                                    [](const Defect& defect) { return defect.is_error; });
  const std::string& checked = options.certificate.empty() ? options.file : options.certificate;
  session.console().note(checked + ": errors: " + std::to_string(errors) + ", warnings: " +
                         std::to_string(defects.size() - static_cast<std::size_t>(errors)));
  if(errors > 0) {
    report.set_error(Input_error(std::move(defects), "valid"));
    return INVALID_INPUT;
  }
  report["status"] = "done";
  return GOAL_REACHED;
}

} // namespace

void add_check_command(Command_line& command_line)
{
  const auto options = std::make_shared<Check_options>();
  CLI::App& command =
      command_line.add_command("check", "list every defect of a curve or a mesh",
                               [options](Session& session) { return check(session, *options); });
  add_file(
      command, "FILE", options->file,
      "a curve, .obj, .ply or .vtp with lines, .polylines.txt, .vect, .xyz, .txt, .dat, "
      ".pdb or .cif, a surface, .off, .obj, .ply or .vtp with faces, or .stl, or polygons, .wkt")
      .required();
  add_mesh(command, options->mesh)
      .description("a surface, or polygons (.wkt); the curve FILE must lie strictly inside");
  add_reading_flags(command, options->reading);
  add_file(command, "--certificate", options->certificate,
           "record of a run, to be replayed with its start curve for FILE and its end curve for "
           "MESH");
  add_file(command, "--domain", options->domain,
           "surface in which the curve must have stayed; with --certificate");
  add_obstacle_option(command, options->obstacles);
  add_number(command, "--wall-distance", options->wall_distance,
             "the distance from MESH and obstacles that the curve FILE must keep")
      .type_name("C");
  command.footer("Prints a line per defect: FILE:LINE: error|warning: KIND: message (nodes i j).\n"
                 "Exit status: 0 no error found, 4 errors found or the certificate rejected.");
}

} // namespace vfc
