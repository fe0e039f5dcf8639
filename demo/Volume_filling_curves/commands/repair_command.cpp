// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc repair: mends a mesh so that vfc fill accepts it.

#include "commands/commands.h"
#include "files/mesh_files.h"
#include "meshes/mesh_to_text.h"
#include "meshes/read_mesh_soup.h"
#include "options/Command_line.h"
#include "options/option_kinds.h"
#include "repair/obstacles.h"
#include "repair/read_mended_mesh.h"
#include "session/Exit_status.h"

#include <memory>
#include <string>
#include <vector>

namespace vfc {
namespace {

struct Repair_options
{
  std::string mesh, output;
  std::vector<std::string> obstacles;
  Mending_options mending;
};

int repair(Session& session, const Repair_options& options)
{
  const std::string extension = lower_case_extension(options.output);
  if(!is_written_mesh_extension(extension))
    throw Usage_error("--output: " + options.output +
                      ": meshes are written to .off, .obj or .ply files, which keep all digits");
  session.report()["input"] = options.mesh;
  session.add_input(options.mesh, "--output");
  for(const std::string& obstacle : options.obstacles) session.add_input(obstacle, "--output");
  session.outputs().add("--output", options.output);
  Mesh mended = read_mended_mesh(session, options.mesh, options.mending).mesh;
  add_or_cut_out_obstacles(session, mended, options.obstacles, options.mending.time_limit);
  Output_files::write(options.output, to_text(mended, extension));
  session.end_stage("writing");
  session.report()["faces"] = mended.number_of_faces();
  session.report()["status"] = "done";
  session.print_summary("wrote " + options.output + ": faces " +
                        std::to_string(mended.number_of_faces()) + '\n');
  return GOAL_REACHED;
}

} // namespace

void add_repair_command(Command_line& command_line)
{
  const auto options = std::make_shared<Repair_options>();
  CLI::App& command =
      command_line.add_command("repair", "close a mesh and remove its self-intersections",
                               [options](Session& session) { return repair(session, *options); });
  add_mesh(command, options->mesh)
      .required()
      ->description("a triangle mesh, .off, .obj, .ply, .stl or .vtp, with defects or without");
  add_file(command, "-o,--output", options->output, "the repaired mesh, .off, .obj or .ply")
      .required();
  add_number(
      command, "--alpha", options->mending.alpha,
      "width of the gaps that wrapping, the last resort, does not enter, in the input's unit; "
      "default: a fiftieth of the diagonal")
      .type_name("A");
  add_number(command, "--time-limit", options->mending.time_limit,
             "time after which the run ends without a result; default: none", not_negative)
      .type_name("SECONDS");
  add_obstacle_option(command, options->obstacles)
      .description("closed surface, of any orientation, to subtract from the inside: a cavity, or "
                   "cut out if it crosses the mesh; repeat the option for several obstacles");
  command.footer(
      "Drops degenerate and repeated faces and small sheets, closes holes, cuts out\n"
      "self-intersections and unites overlapping shells. Only if that is not enough, a new\n"
      "surface is wrapped around all faces. Prints a line for each repair, and how far "
      "the\nsurface moved. Equal inputs give equal meshes.\n"
      "Shells that are oriented inward and overlap others are cavities, and are cut out.\n"
      "Exit status: 0 vfc fill accepts the mesh, 2 the time limit was reached, 4 the mesh cannot "
      "be\nrepaired, 5 interrupted.");
}

} // namespace vfc
