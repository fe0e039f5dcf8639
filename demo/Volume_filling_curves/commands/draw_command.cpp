// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc draw: a picture of a curve, and of a surface around it.

#include "commands/commands.h"
#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "options/Command_line.h"
#include "pictures/curve_pictures.h"
#include "session/Exit_status.h"
#include "session/errors.h"

#include <memory>
#include <string>

namespace vfc {
namespace {

struct Draw_options
{
  std::string file, mesh, picture;
  bool is_network = false;
};

bool has_extension(const std::string& file, const std::string& extension)
{
  return file.size() > extension.size() &&
         file.compare(file.size() - extension.size(), extension.size(), extension) == 0;
}

std::string picture(Session& session, const Draw_options& options)
{
  const Curve curve = read_curve(session, options.file, options.is_network);
  Mesh mesh;
  if(!options.mesh.empty()) mesh = read_mesh(session, options.mesh).mesh;
  return has_extension(options.picture, ".svg") ? svg_picture(curve, mesh)
                                                : png_picture(curve, mesh);
}

int draw(Session& session, const Draw_options& options)
{
  if(!has_extension(options.picture, ".svg") && !has_extension(options.picture, ".png"))
    throw Usage_error("--output: " + options.picture + ": pictures are .svg or .png files");
  session.add_input(options.file);
  if(!options.mesh.empty()) session.add_input(options.mesh);
  session.outputs().add("--output", options.picture);
  Output_files::write(options.picture, picture(session, options));
  session.end_stage("drawing");
  session.report()["status"] = "done";
  session.print_summary("wrote " + options.picture + '\n');
  return GOAL_REACHED;
}

} // namespace

void add_draw_command(Command_line& command_line)
{
  const auto options = std::make_shared<Draw_options>();
  CLI::App& command =
      command_line.add_command("draw", "a shaded picture of a curve, also in a surface",
                               [options](Session& session) { return draw(session, *options); });
  add_curve(command, options->file);
  add_mesh(command, options->mesh).description("a surface, drawn translucent around the curve");
  add_file(command, "-o,--output", options->picture, "the picture, .svg or .png").required();
  add_network_flag(command, options->is_network);
}

} // namespace vfc
