// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc measure: what a curve is like.

#include "Command_line.h"
#include "Exit_status.h"
#include "commands.h"
#include "curve_files.h"
#include "numbers.h"
#include "shape.h"

#include <cmath>
#include <memory>
#include <string>

namespace vfc {
namespace {

struct Measure_options
{
  std::string file;
  double thickness = 0;
  bool is_network = false;
};

std::string cell(const Report::Json& value)
{
  if(value.is_number_float() && std::isfinite(double(value))) return to_text(double(value));
  if(value.is_null() || value.is_number_float()) return "-";
  if(!value.is_array()) return value.dump();
  std::string text;
  for(const Report::Json& item : value)
    text += (text.empty() ? "" : " ") + (item.is_array() ? '[' + cell(item) + ']' : cell(item));
  return text;
}

// One line per key of the report.
std::string table(const Report& report)
{
  constexpr std::size_t width = 28;
  std::string text;
  for(const std::string key :
      {"components", "nodes_end", "length_end", "component_lengths", "thickness", "min_clearance",
       "total_curvature", "component_total_curvatures", "max_curvature", "min_bend_radius",
       "polygonal_thickness", "ropelength", "average_crossing_number", "linking_matrix",
       "medial_radius"})
    text += key + std::string(width - key.size(), ' ') + cell(report[key]) + '\n';
  return text;
}

int measure(Session& session, const Measure_options& options)
{
  const Curve curve = read_curve(session, options.file, options.is_network);
  report_shape(session.report(), curve, options.thickness);
  session.end_stage("measuring");
  session.report()["status"] = "done";
  session.print_result(table(session.report()));
  return GOAL_REACHED;
}

} // namespace

void add_measure_command(Command_line& command_line)
{
  const auto options = std::make_shared<Measure_options>();
  CLI::App& command =
      command_line.add_command("measure", "what a curve is like",
                               [options](Session& session) { return measure(session, *options); });
  add_curve(command, options->file);
  add_number(command, "--thickness", options->thickness,
             "r, in the input's unit: segments within pi r of each other along the curve do not "
             "count for min_clearance; needed for medial_radius")
      .type_name("R");
  add_network_flag(command, options->is_network);
  command.footer(
      "Prints the keys of the report, - for what does not apply. Lengths are in the input's unit,\n"
      "curvatures in its reciprocal, angles in radians.\n"
      "  total_curvature      sum of the turning angles; 2 pi for a circle\n"
      "  min_bend_radius      least bend radius of a corner, 1 / max_curvature\n"
      "  polygonal_thickness  radius of the thickest tube around the curve\n"
      "  ropelength           length / polygonal_thickness; 2 pi for a circle\n"
      "  min_clearance        least distance of two segments that are not neighbors\n"
      "  medial_radius        mean of the medial radii, capped at 2 r");
}

} // namespace vfc
