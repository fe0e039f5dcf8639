// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/Fill_options.h"

#include "options/lists.h"
#include "options/numbers.h"
#include "options/option_kinds.h"
#include "options/ports.h"

namespace vfc {
namespace {

using CGAL::Volume_filling_curves::Filling_start;
using CGAL::Volume_filling_curves::Wall;

// The three options for the density of the curve.
void add_density_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& thickness =
      add_number(command, "--thickness", options.parameters.thickness,
                 "r, in the input's unit: most points end within r of the curve; default: a "
                 "quarter of the widest inscribed ball's radius, more if the curve would have over "
                 "200,000 nodes");
  thickness.type_name("R");
  CLI::Option& field =
      add_file(command, "--thickness-field", options.thickness_field,
               "a varying r: a PLY file with the vertex property thickness, or a CSV file with a "
               "value per vertex of MESH, in the order of vfc convert MESH mesh.ply");
  CLI::Option& length =
      add_number(command, "--length", options.parameters.length,
                 "length of the curve, reached within 2 %, instead of a thickness");
  length.type_name("L");
  field.excludes(&thickness);
  length.excludes(&thickness)->excludes(&field);
}

// How round the curve is.
void add_shape_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& preview = *command.add_flag_callback(
      "--preview", [&options] { options.parameters.round_bends = false; },
      "without rounding, in 0.3 to 0.7 of the time: bends of 0.15 r, and strands 0.7 r apart in "
      "places");
  command.add_flag("--finish", "with rounding; the default")->group("Shape of the result");
  add_number(command, "--bend-radius", options.parameters.bend_radius,
             "least radius of bends; default: 0.85 r; if R exceeds r, r becomes R")
      .type_name("R");
  add_number(command, "--strand-distance", options.parameters.strand_distance,
             "least strand distance; default: 1.6 r; if D exceeds 1.8 r, r becomes D / 1.8")
      .type_name("D");
  for(const char* rounding : {"--finish", "--bend-radius", "--strand-distance"})
    preview.excludes(command.get_option(rounding));
}

// A curve with the symmetry of its domain.
void add_symmetry_option(CLI::App& command, Fill_options& options)
{
  CLI::Option& symmetry = add_text(
      command, "--symmetry", options.symmetry,
      "fill one sector of MESH with an arc, and add its images. The sector of mirror is half of "
      "MESH, at a plane; that of rotation:K is a K-th of a turn about an axis. The numbers are a "
      "point and the normal of the plane or the direction of the axis; default: the middle of the "
      "box, normal x, direction z");
  symmetry.type_name("mirror|rotation:K[:X,Y,Z,NX,NY,NZ]")->needs("--thickness");
  for(const char* other : {"--curve", "--port", "--volume-shares"})
    symmetry.excludes(command.get_option(other));
}

void add_direction_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& field = add_text(
      command, "--direction-field", options.direction_field,
      "direction that strands follow: a vector x,y,z, a PLY file with the vertex properties "
      "direction_x, direction_y and direction_z, or a CSV file with a vector per vertex of MESH; "
      "sign and length do not matter, and zero means no preference");
  field.type_name("FILE|X,Y,Z");
  add_number(command, "--direction-weight", options.parameters.direction_weight,
             "extra weight of length across the field; large values leave gaps where strands turn")
      .needs(&field);
}

// Reads "A,B,...".
std::vector<double> read_volume_shares(const std::string& text)
{
  std::vector<double> shares;
  for(const std::string& item : items_of_list(text))
    if(!parse(item, shares.emplace_back()) || !(shares.back() > 0))
      throw CLI::ValidationError("--volume-shares", "'" + item + "' is not a positive number");
  return shares;
}

// The start of the curve.
void add_start_options(CLI::App& command, Fill_options& options)
{
  CLI::Option& curve =
      add_file(command, "--curve", options.start,
               "curve to start from, inside MESH; default: a small circle in the widest ball");
  add_port_option(command, options.ports).excludes(&curve);
  command
      .add_option_function<std::string>(
          "--volume-shares",
          [&shares = options.parameters.volume_shares](const std::string& text) {
            shares = read_volume_shares(text);
          },
          "shares of the volume for the components of CURVE, or for the arcs between ports; only "
          "their ratios matter; default: equal shares")
      ->type_name("A,B,...");
  add_curve_options(command, options.curve);
  for(const char* option : {"--network", "--closed", "--open", "--pin", "--free-ends"})
    command.get_option(option)->needs(&curve);
  add_choice(command, "--start", options.parameters.start,
             {{"tree", Filling_start::TREE}, {"circle", Filling_start::CIRCLE}},
             "tree: fingers first grow through the whole inside; circle: the curve grows from its "
             "start, as for a film, which takes several times as long");
}

} // namespace

void add_fill_options(CLI::App& command, Fill_options& options)
{
  add_mesh(command, options.mesh)
      .description("a closed triangle mesh, .off, .obj, .ply, .stl or .vtp, or polygons with holes "
                   "in the plane, .wkt")
      ->required();
  command.add_flag("--repair", options.may_repair,
                   "repair MESH and obstacles first, like vfc repair, and report each repair; "
                   "obstacles that cross MESH are cut out of it; vertices of the repaired mesh "
                   "take the values at the nearest points of MESH");
  add_obstacle_option(command, options.obstacles);
  add_curve_output(command, options.output);
  add_file(
      command, "--certificate", options.certificate,
      "record of all certified changes, for vfc check --certificate with MESH for --domain and the "
      "same obstacles; without --curve the start is written to FILE.start.obj; with --symmetry "
      "the arc and its sector are written to FILE.end.obj and FILE.domain.off");
  add_film_options(command, options.film);
  add_checkpoint_options(command, options.saving);
  add_start_options(command, options);
  add_density_options(command, options);
  add_symmetry_option(command, options);
  add_shape_options(command, options);
  add_direction_options(command, options);
  add_choice(command, "--wall", options.parameters.wall,
             {{"cover", Wall::COVER}, {"keep-clear", Wall::KEEP_CLEAR}},
             "cover: the curve covers the boundary; keep-clear: it keeps as far from the boundary "
             "as from itself");
  add_number(command, "--wall-distance", options.parameters.wall_distance,
             "the distance from MESH and obstacles that the curve keeps, except in the necks of "
             "ports, in the input's unit")
      .type_name("C");
  add_stop_options(command, options.parameters);
  add_seed_option(command, options.parameters.random_seed,
                  "seed of the tree of fingers and of the samples for coverage");
  add_flow_options(command, options.parameters);
  command.get_option("--lambda")
      ->description(
          "locality of the flow, in units of 1/r^2; 30 times this value while the curve opens or "
          "grows");
}

} // namespace vfc
