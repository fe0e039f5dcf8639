// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc draw: a picture of a curve.

#include "Command_line.h"
#include "Exit_status.h"
#include "commands.h"
#include "curve_files.h"
#include "errors.h"

#include <CGAL/Volume_filling_curves/IO/write_svg.h>

#include <locale>
#include <memory>
#include <sstream>
#include <string>

namespace vfc {
namespace {

struct Draw_options
{
  std::string file, picture;
  bool is_network = false;
};

bool is_svg(const std::string& file)
{
  const std::string extension = ".svg";
  return file.size() > extension.size() &&
         file.compare(file.size() - extension.size(), extension.size(), extension) == 0;
}

int draw(Session& session, const Draw_options& options)
{
  if(!is_svg(options.picture))
    throw Usage_error("--output: " + options.picture + ": pictures are .svg files");
  session.outputs().add("--output", options.picture);
  const Curve curve = read_curve(session, options.file, options.is_network);
  std::ostringstream picture;
  picture.imbue(std::locale::classic());
  CGAL::IO::write_svg(picture, curve);
  Output_files::write(options.picture, picture.str());
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
      command_line.add_command("draw", "a shaded picture of a curve",
                               [options](Session& session) { return draw(session, *options); });
  add_curve(command, options->file);
  command.add_option("-o,--output", options->picture, "the picture, .svg")
      ->required()
      ->type_name("FILE");
  add_network_flag(command, options->is_network);
}

} // namespace vfc
