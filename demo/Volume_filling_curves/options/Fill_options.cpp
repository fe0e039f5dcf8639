// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/Fill_options.h"

#include "options/Command_line.h"

namespace vfc {
namespace {

using CGAL::Volume_filling_curves::Filling_start;
using CGAL::Volume_filling_curves::Wall;

// The three ways to say how dense the curve is.
void add_density_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& thickness = add_number(
      command, "--thickness", options.parameters.thickness,
      "r, the radius with which the curve fills, in the input's unit; default: a quarter "
      "of the widest inscribed ball's radius");
  thickness.type_name("R");
  CLI::Option& field =
      add_file(command, "--thickness-field", options.thickness_field,
               "r that varies: a PLY file with the vertex property thickness, or a CSV file with a "
               "value per vertex of MESH, in the order of vfc convert MESH mesh.ply");
  CLI::Option& length =
      add_number(command, "--length", options.parameters.length,
                 "length of the curve, instead of a thickness, which is found within 2 %");
  length.type_name("L");
  field.excludes(&thickness);
  length.excludes(&thickness)->excludes(&field);
}

void add_direction_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& field = *command.add_option(
      "--direction-field", options.direction_field,
      "strands follow it: a vector x,y,z, or a PLY file with the vertex properties direction_x, "
      "direction_y and direction_z, or a CSV file with a vector per vertex of MESH; neither sign "
      "nor length matters, and zero asks for nothing");
  field.type_name("FILE|X,Y,Z");
  add_number(
      command, "--direction-weight", options.parameters.direction_weight,
      "how much more length across the field counts; larger ones leave gaps where strands turn")
      .needs(&field);
}

// What to start from.
void add_start_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& curve =
      add_file(command, "--curve", options.start,
               "the curve to start from, inside MESH; default: a small circle at the widest place");
  add_curve_options(command, options.curve);
  for(const char* option : {"--network", "--closed", "--open", "--pin", "--free-ends"})
    command.get_option(option)->needs(&curve);
  add_choice(command, "--start", options.parameters.start,
             {{"tree", Filling_start::TREE}, {"circle", Filling_start::CIRCLE}},
             "tree: fingers reach out from there all over the inside at once; circle: the curve "
             "grows from there, which makes a film, and takes several times as long");
}

} // namespace

void add_fill_options(CLI::App& command, Fill_options& options)
{
  add_mesh(command, options.mesh).required();
  command.add_flag(
      "--repair", options.may_repair,
      "mend MESH and obstacles first, as vfc repair does, and say what was done; obstacles that "
      "cross MESH are cut out of it; values per vertex of MESH go to the nearest vertices");
  add_obstacle_option(command, options.obstacles);
  add_curve_output(command, options.output);
  add_file(
      command, "--certificate", options.certificate,
      "the record of all certified changes, to be verified by vfc check --certificate with MESH "
      "for --domain, and the same obstacles; without --curve the circles that it starts from go to "
      "FILE.start.obj");
  add_film_options(command, options.film);
  add_checkpoint_options(command, options.saving);
  add_start_options(command, options);
  add_density_options(command, options);
  add_direction_options(command, options);
  add_choice(
      command, "--wall", options.parameters.wall,
      {{"cover", Wall::COVER}, {"keep-clear", Wall::KEEP_CLEAR}},
      "cover: strands up to the wall; keep-clear: the curve keeps away from it as from itself");
  add_stop_options(command, options.parameters);
  add_seed_option(command, options.parameters.random_seed,
                  "of the tree, and of the samples that coverage is measured with");
  add_flow_options(command, options.parameters);
  command.get_option("--lambda")
      ->description(
          "locality of the flow, in units of 1/r^2; 30 times that while the curve opens or grows");
}

} // namespace vfc
