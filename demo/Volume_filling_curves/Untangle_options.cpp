// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Untangle_options.h"

#include "Command_line.h"

#include <map>

namespace vfc {
namespace {

using CGAL::Volume_filling_curves::Preconditioner;

const std::map<std::string, Preconditioner>& preconditioners()
{
  static const std::map<std::string, Preconditioner> names = {
      {"medial", Preconditioner::MEDIAL},
      {"h1", Preconditioner::H1},
      {"l2", Preconditioner::L2},
      {"quasi-newton", Preconditioner::QUASI_NEWTON}};
  return names;
}

void add_file_options(CLI::App& command, Untangle_options& options)
{
  add_curve(command, options.file);
  command.add_option("-o,--output", options.output, "the result, .obj or .polylines.txt")
      ->type_name("FILE");
  command
      .add_option("--map", options.map,
                  "for each node of the result, a line with its number in CURVE, 0 if it is new")
      ->type_name("FILE");
  CLI::Option* const frames =
      command
          .add_option("--frames", options.frames, "folder for the curve of every K-th iteration")
          ->type_name("DIR");
  add_whole_number(command, "--every", options.every, "K, the iterations between two frames", 1)
      .capture_default_str()
      ->needs(frames);
}

void add_curve_options(CLI::App& command, Untangle_options& options)
{
  add_network_flag(command, options.is_network);
  command
      .add_option(
          "--pin", options.pin,
          "nodes that stay: ends, or numbers i,j,k in file order from 1; OBJ lines 'fixed i j "
          "k' add to them")
      ->type_name("NODES");
  command.add_flag("--free-ends", options.has_free_ends,
                   "let the ends of open curves move; otherwise they are pinned");
  command.add_flag("--keep-length", options.keeps_length,
                   "scale the result to the length of the input");
  command.add_flag("--finish", options.finishes,
                   "after a proof that nothing is knotted flow on until converged, a small loop");
}

void add_stop_options(CLI::App& command, Untangle_options& options)
{
  add_number(command, "--time-limit", options.stop.time_limit, "default: none", true)
      .type_name("SECONDS");
  add_whole_number(command, "--max-iterations", options.stop.max_iterations,
                   "the largest number of iterations", 0)
      .capture_default_str();
  add_number(command, "--tolerance", options.stop.tolerance,
             "converged if gradient_norm is less; dimensionless", true)
      .capture_default_str();
}

void add_flow_options(CLI::App& command, Untangle_options& options)
{
  const std::size_t most_directions = 1024;
  add_number(command, "--thickness", options.flow.thickness,
             "r, the distance that strands keep from the medial surface between them, in the "
             "input's unit; default: the 25th percentile of the medial radii")
      .type_name("R");
  add_whole_number(command, "--directions", options.flow.number_of_directions,
                   "medial spheres per node", 1, most_directions)
      .capture_default_str();
  add_number(command, "--rmax", options.flow.max_radius, "largest medial radius, in units of r")
      .capture_default_str();
  add_number(command, "--spacing", options.flow.spacing,
             "least length h of an edge, in units of r; edges longer than 2 h are split")
      .capture_default_str();
  add_number(command, "--lambda", options.flow.screening, "locality of the flow, in units of 1/r^2")
      .capture_default_str();
  add_number(command, "--beta", options.flow.coupling,
             "coupling along medial spheres, dimensionless", true)
      .capture_default_str();
  add_number(command, "--tau", options.flow.time_step,
             "the paper's fixed time step, dimensionless; default: adaptive, moves up to 0.5 r");
  command
      .add_option("--preconditioner", options.name_of_preconditioner,
                  "medial, h1, l2 or quasi-newton")
      ->check(CLI::IsMember(preconditioners()).description(""))
      ->capture_default_str()
      ->type_name("NAME");
}

} // namespace

Preconditioner Untangle_options::preconditioner() const
{
  return preconditioners().at(name_of_preconditioner);
}

void add_untangle_options(CLI::App& command, Untangle_options& options)
{
  add_file_options(command, options);
  add_curve_options(command, options);
  add_stop_options(command, options);
  command.add_option("--strategy", options.strategy, "flow: continuous motion")
      ->check(CLI::IsMember({"flow"}).description(""))
      ->capture_default_str()
      ->type_name("NAME");
  add_whole_number(command, "--seed", options.seed, "of random choices, which flow does not make",
                   0)
      .capture_default_str();
  add_flow_options(command, options);
}

} // namespace vfc
