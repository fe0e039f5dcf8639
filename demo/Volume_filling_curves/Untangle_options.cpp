// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Untangle_options.h"

#include "Command_line.h"

namespace vfc {

using CGAL::Volume_filling_curves::Untangling_strategy;

Untangling_strategy Untangle_options::strategy() const
{
  if(name_of_strategy == "flow") return Untangling_strategy::FLOW;
  return name_of_strategy == "tighten" ? Untangling_strategy::TIGHTEN : Untangling_strategy::AUTO;
}

void add_untangle_options(CLI::App& command, Untangle_options& options)
{
  constexpr std::size_t most_chains = 1024;
  add_curve(command, options.file);
  add_curve_output(command, options.output);
  add_file(
      command, "--certificate", options.certificate,
      "the record of all certified changes, to be verified by vfc check --certificate; as text "
      "if the name ends with .txt");
  add_film_options(command, options.film);
  add_curve_options(command, options.curve);
  command.add_flag("--keep-length", options.keeps_length,
                   "scale the result to the length of the input");
  command.add_flag(
      "--finish", options.finishes,
      "after a proof that nothing is knotted go on until the curve is round; several get tight");
  add_stop_options(command, options.stop);
  command.get_option("--max-iterations")
      ->description("the largest number of iterations of the flow; with tighten, of sweeps");
  add_number(command, "--tolerance", options.stop.tolerance,
             "converged if gradient_norm is less; dimensionless", not_negative)
      .capture_default_str();
  command
      .add_option(
          "--strategy", options.name_of_strategy,
          "flow: continuous motion, for a film; tighten: a random search for a polygon with few "
          "edges; auto: the search first, then the flow to an even, smooth shape")
      ->check(CLI::IsMember({"flow", "tighten", "auto"}).description(""))
      ->capture_default_str()
      ->type_name("NAME");
  command
      .add_option("--chains", options.number_of_chains,
                  "independent random searches, of which the fastest wins; they share the threads")
      ->check(CLI::Range(std::size_t(1), most_chains).description(""))
      ->capture_default_str()
      ->type_name("N");
  add_seed_option(command, options.seed, "of the random search");
  add_number(command, "--thickness", options.flow.parameters.thickness,
             "r, the distance that strands keep from the medial surface between them, in the "
             "input's unit; default: the 25th percentile of the medial radii")
      .type_name("R");
  add_flow_options(command, options.flow);
}

} // namespace vfc
