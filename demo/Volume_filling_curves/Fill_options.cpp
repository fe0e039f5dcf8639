// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Fill_options.h"

#include "Command_line.h"

namespace vfc {
namespace {

// The three ways to say how dense the curve is.
void add_density_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& thickness = add_number(
      command, "--thickness", options.flow.parameters.thickness,
      "r, the radius with which the curve fills, in the input's unit; default: a quarter "
      "of the widest inscribed ball's radius");
  thickness.type_name("R");
  CLI::Option& field =
      add_file(command, "--thickness-field", options.thickness_field,
               "r that varies: a PLY file with the vertex property thickness, or a CSV file with a "
               "value per vertex of MESH");
  CLI::Option& length =
      add_number(command, "--length", options.length,
                 "length of the curve, instead of a thickness, which is found within 2 %");
  length.type_name("L");
  field.excludes(&thickness);
  length.excludes(&thickness)->excludes(&field);
}

// What to start from.
void add_start_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& curve =
      add_file(command, "--curve", options.start,
               "the curve to start from, inside MESH; default: a small circle at the widest place");
  add_curve_options(command, options.curve);
  for(const char* option : {"--network", "--pin", "--free-ends"})
    command.get_option(option)->needs(&curve);
}

} // namespace

void add_fill_options(CLI::App& command, Fill_options& options)
{
  add_mesh(command, options.mesh).required();
  add_curve_output(command, options.output);
  add_film_options(command, options.film);
  add_start_options(command, options);
  add_density_options(command, options);
  command
      .add_option("--wall", options.wall,
                  "cover: strands up to the wall; keep-clear: the curve keeps away from it as from "
                  "itself")
      ->check(CLI::IsMember({"cover", "keep-clear"}).description(""))
      ->capture_default_str()
      ->type_name("NAME");
  add_stop_options(command, options.stop);
  add_seed_option(command, options.seed, "of the samples that coverage is measured with");
  options.flow.parameters.max_radius = 6; // that of fill()
  add_flow_options(command, options.flow);
  command.get_option("--lambda")
      ->description("locality of the flow, in units of 1/r^2; 30 times that while the curve grows");
}

} // namespace vfc
