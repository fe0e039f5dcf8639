// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc convert: a curve or a mesh in another format, resampled, as arcs, or as a tube's surface.

#include "arc_files/convert_to_arcs.h"
#include "commands/commands.h"
#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "files/tube_files.h"
#include "formats/curve_formats.h"
#include "meshes/Mesh_findings.h"
#include "meshes/mesh_to_text.h"
#include "meshes/read_mesh_soup.h"
#include "options/Command_line.h"
#include "options/numbers.h"
#include "options/option_kinds.h"
#include "resampling/resample.h"
#include "session/Exit_status.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

struct Convert_options
{
  std::string file, second, output; // the latter two are the same, given in either way
  double radius = 0, thickness = 0; // 0: no tube, and no medial radii
  double spacing = 0;               // 0: the nodes stay
  std::size_t number_of_sides = 16;
  Arc_options arcs;
  Curve_reading reading;
};

// Refuses a thickness for files without a column for the medial radii.
void check_radii(const Convert_options& options)
{
  const Curve_format* const format = curve_format_of(options.output);
  if(options.thickness > 0 && format != nullptr && format->write_with_columns == nullptr)
    throw Usage_error("--thickness: " + options.output +
                      ": medial radii are written to .ply and .vtp files");
}

void plan_files(Session& session, const Convert_options& options)
{
  check_radii(options);
  check_unit(options.arcs.unit, options.output);
  session.add_input(options.file, "--output");
  if(options.arcs.is_wanted)
    plan_arc_files(session, options.arcs, options.output);
  else if(options.radius > 0)
    add_tube_file(session.outputs(), "--output", options.output);
  else
    add_curve_file(session.outputs(), "--output", options.output);
}

void convert_to_tube(Session& session, const Convert_options& options, const Curve& curve)
{
  const Mesh mesh = tube(curve, options.radius, options.number_of_sides);
  const double thickness = curves::polygonal_thickness(curve);
  if(options.radius >= thickness)
    session.console().warn(
        "--tube: the surface may intersect itself, since the radius is not less than " +
        to_text(thickness) + ", the polygonal thickness");
  write_tube(options.output, mesh, to_string(options.arcs.unit));
  session.report()["radius"] = options.radius;
  session.report()["polygonal_thickness"] = thickness;
  session.report()["faces"] = mesh.number_of_faces();
  session.print_summary("wrote " + options.output + ": faces " +
                        std::to_string(mesh.number_of_faces()) + '\n');
}

// A file that may hold either has a surface if it has faces and no lines.
bool is_surface(const std::string& file)
{
  if(curve_format_of(file) == nullptr) return is_mesh_file(file);
  const std::vector<curves::Curve_defect> defects = read_curve_draft(file, {}).defects.listed();
  return std::any_of(defects.begin(), defects.end(), [](const curves::Curve_defect& defect) {
    return defect.kind == curves::Curve_defect_kind::FACES_ONLY;
  });
}

// The vertices keep the order in which values are given for them, whatever is wrong with the mesh.
int convert_mesh(Session& session, const Convert_options& options)
{
  const std::string extension = lower_case_extension(options.output);
  if(options.radius > 0 || options.thickness > 0 || options.spacing > 0 || options.arcs.is_wanted)
    throw Usage_error("CURVE: " + options.file + ": is a surface, not a curve");
  if(!is_written_mesh_extension(extension))
    throw Usage_error("--output: " + options.output +
                      ": meshes are written to .off, .obj or .ply files, which keep all digits");
  session.report()["input"] = options.file;
  session.add_input(options.file, "--output");
  session.outputs().add("--output", options.output);
  Mesh_findings findings(options.file);
  const Mesh_soup soup = read_mesh_soup(options.file, findings);
  accept(session, findings);
  Output_files::write(options.output, to_text(soup, extension));
  session.end_stage("writing");
  session.report()["faces"] = soup.faces.size();
  session.report()["status"] = "done";
  session.print_summary("wrote " + options.output + ": vertices " +
                        std::to_string(soup.points.size()) + ", faces " +
                        std::to_string(soup.faces.size()) + '\n');
  return GOAL_REACHED;
}

void resample_evenly(Session& session, double spacing, Curve& curve)
{
  Resampling resampling;
  try {
    resampling = resample(curve, spacing);
  } catch(const std::invalid_argument& error) {
    throw Usage_error(std::string("--spacing: ") + error.what());
  }
  session.end_stage("resampling");
  session.report()["distance"] = resampling.max_distance;
  session.print_summary("resampled: " + counted(curve.number_of_nodes(), "node") + ", edges " +
                        to_text(resampling.min_spacing) + " to " + to_text(resampling.max_spacing) +
                        ", within " + to_text(resampling.max_distance) + " of CURVE\n");
  if(resampling.number_of_kept_nodes > 0)
    session.console().warn("--spacing: " + counted(resampling.number_of_kept_nodes, "node") +
                           " of CURVE stayed, pinned or in the way of another strand");
}

// Returns the exit status.
int convert_curve(Session& session, const Convert_options& options, const Curve& curve)
{
  session.report()["nodes_end"] = curve.number_of_nodes();
  session.report()["length_end"] = curves::length(curve);
  if(options.arcs.is_wanted)
    return convert_to_arcs(session, options.arcs, curve, options.file, options.output);
  if(options.radius > 0) {
    convert_to_tube(session, options, curve);
  } else {
    write_curve(options.output, curve, options.thickness);
    session.print_summary("wrote " + options.output + ": nodes " +
                          std::to_string(curve.number_of_nodes()) + '\n');
  }
  return GOAL_REACHED;
}

int convert(Session& session, Convert_options options)
{
  if(options.output.empty() == options.second.empty())
    throw Usage_error("--output: needs one file, here or as the second argument");
  if(options.output.empty()) options.output = options.second;
  if(is_surface(options.file)) return convert_mesh(session, options);
  plan_files(session, options);
  Curve curve = read_curve(session, options.file, options.reading);
  if(options.spacing > 0) resample_evenly(session, options.spacing, curve);
  const int exit_status = convert_curve(session, options, curve);
  session.end_stage("writing");
  session.report()["status"] = "done";
  return exit_status;
}

} // namespace

void add_convert_command(Command_line& command_line)
{
  const auto options = std::make_shared<Convert_options>();
  CLI::App& command = command_line.add_command(
      "convert",
      "write a curve or a mesh in another format, a curve as arcs, or the tube around it",
      [options](Session& session) { return convert(session, *options); });
  add_curve(command, options->file);
  add_file(command, "OUT", options->second, "the same as --output");
  add_curve_output(command, options->output)
      .description("the curve in another format, with --arcs .csv, .step or .svg, or with --tube a "
                   "surface, .stl, .off, .ply or .obj");
  add_number(
      command, "--spacing", options->spacing,
      "resample evenly, with nodes this far apart along CURVE; the largest distance to CURVE "
      "is printed")
      .type_name("H");
  CLI::Option& arcs = add_arc_options(command, options->arcs);
  CLI::Option& tube =
      add_number(command, "--tube", options->radius,
                 "write the surface of the tube of this radius, in the input's unit");
  tube.type_name("R")->excludes(&arcs);
  add_whole_number(command, "--sides", options->number_of_sides,
                   "number of sides of the tube's sections", 3, 1024)
      .capture_default_str()
      ->needs(&tube);
  add_number(command, "--thickness", options->thickness,
             "r, in the input's unit; .ply and .vtp then contain medial radii, capped at 2 r")
      .type_name("R")
      ->excludes(&tube)
      ->excludes(&arcs);
  add_reading_flags(command, options->reading);
  command.footer(
      "Coordinates keep all digits; .ply, .vtp and .obj files also keep pinned nodes, and the "
      "order\n"
      "of nodes in networks. For each node, .ply and .vtp files contain\n"
      "  origin     its number in CURVE, from 0\n"
      "  component  the number of its component, from 0\n"
      "  curvature  the reciprocal of the bend radius, 0 at ends\n"
      "  radius     with --thickness: the mean of the medial radii\n"
      "A mesh is written unchanged, in .off, .obj or .ply, with its order of vertices: corners of\n"
      ".stl files are numbered by first occurrence. Values per vertex, as for\n"
      "vfc fill --thickness-field, have the same order.\n"
      "The surface of a tube is closed and oriented outward. It does not intersect itself if R is\n"
      "less than the polygonal thickness that vfc measure reports. Junctions have no tube.");
}

} // namespace vfc
