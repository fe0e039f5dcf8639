// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc convert: a curve in another format, or the surface of the tube around it.

#include "commands/commands.h"
#include "files/curve_files.h"
#include "files/tube_files.h"
#include "options/Command_line.h"
#include "options/numbers.h"
#include "session/Exit_status.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <memory>
#include <string>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

struct Convert_options
{
  std::string file, output;
  double radius = 0, thickness = 0; // 0: no tube, and no medial radii
  std::size_t number_of_sides = 16;
  bool is_network = false;
};

void plan_files(Session& session, const Convert_options& options)
{
  session.add_input(options.file, "--output");
  if(options.radius > 0)
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
        "--tube: the surface may meet itself, since the radius is not less than " +
        to_text(thickness) + ", the polygonal thickness");
  write_tube(options.output, mesh);
  session.report()["radius"] = options.radius;
  session.report()["polygonal_thickness"] = thickness;
  session.report()["faces"] = mesh.number_of_faces();
  session.print_summary("wrote " + options.output + ": faces " +
                        std::to_string(mesh.number_of_faces()) + '\n');
}

int convert(Session& session, const Convert_options& options)
{
  plan_files(session, options);
  const Curve curve = read_curve(session, options.file, options.is_network);
  if(options.radius > 0) {
    convert_to_tube(session, options, curve);
  } else {
    write_curve(options.output, curve, options.thickness);
    session.print_summary("wrote " + options.output + ": nodes " +
                          std::to_string(curve.number_of_nodes()) + '\n');
  }
  session.end_stage("writing");
  session.report()["nodes_end"] = curve.number_of_nodes();
  session.report()["length_end"] = curves::length(curve);
  session.report()["status"] = "done";
  return GOAL_REACHED;
}

} // namespace

void add_convert_command(Command_line& command_line)
{
  const auto options = std::make_shared<Convert_options>();
  CLI::App& command =
      command_line.add_command("convert", "a curve in another format, or the tube around it",
                               [options](Session& session) { return convert(session, *options); });
  add_curve(command, options->file);
  add_curve_output(command, options->output)
      .required()
      ->description("the curve in another format, or with --tube a surface, .stl, .off, .ply or "
                    ".obj");
  CLI::Option& tube =
      add_number(command, "--tube", options->radius,
                 "write the surface of the tube of this radius, in the input's unit");
  tube.type_name("R");
  add_whole_number(command, "--sides", options->number_of_sides, "of the tube's sections", 3, 1024)
      .capture_default_str()
      ->needs(&tube);
  add_number(command, "--thickness", options->thickness,
             "r, in the input's unit: .ply and .vtp tell the medial radii, capped at 2 r")
      .type_name("R")
      ->excludes(&tube);
  add_network_flag(command, options->is_network);
  command.footer(
      "Coordinates keep all their digits; with .ply, .vtp and .obj also pinned nodes are kept, "
      "and\n"
      "the order of nodes in networks. .ply and .vtp tell of each node\n"
      "  origin     its number in CURVE, from 0\n"
      "  component  from 0\n"
      "  curvature  the reciprocal of the bend radius, 0 at ends\n"
      "  radius     with --thickness: mean of the medial radii\n"
      "The surface of a tube is closed and oriented to the outside, and does not meet itself if R "
      "is\n"
      "less than the polygonal thickness that vfc measure tells. There is none around junctions.");
}

} // namespace vfc
