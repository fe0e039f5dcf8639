// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/Untangle_options.h"

#include "options/option_kinds.h"

namespace vfc {

using CGAL::Volume_filling_curves::Untangling_strategy;

void add_untangle_options(CLI::App& command, Untangle_options& options)
{
  constexpr std::size_t max_chains = 1024;
  auto& parameters = options.parameters;
  add_curve(command, options.file);
  add_curve_output(command, options.output);
  add_file(command, "--certificate", options.certificate,
           "record of all certified changes, for vfc check --certificate; as text if the name ends "
           "with .txt");
  add_file(command, "--domain", options.domain,
           "closed triangle mesh in which the curve stays; shells within it are obstacles. The "
           "strategy is then flow, since the search ignores meshes");
  add_film_options(command, options.film);
  add_checkpoint_options(command, options.saving);
  add_curve_options(command, options.curve);
  command.add_flag("--keep-length", parameters.keep_length,
                   "scale the result to the length of the input");
  command.add_flag_callback(
      "--finish",
      [&parameters] {
        parameters.stop_at_proof = false;
        parameters.lower_ropelength = true;
      },
      "after a proof of unknottedness, continue until a single curve is round, or several are "
      "tight; lower the ropelength of tight closed curves");
  add_stop_options(command, parameters);
  command.get_option("--max-iterations")
      ->description(
          "the largest number of iterations of the flow or, with --strategy search, of sweeps of "
          "100 attempted moves per edge");
  add_number(command, "--tolerance", parameters.tolerance,
             "converged if gradient_norm is less; dimensionless", not_negative)
      .capture_default_str();
  add_choice(
      command, "--strategy", parameters.strategy,
      {{"auto", Untangling_strategy::AUTO},
       {"flow", Untangling_strategy::FLOW},
       {"search", Untangling_strategy::SEARCH},
       {"tighten", Untangling_strategy::SEARCH}},
      "flow: continuous motion, for a film; search, or tighten: a random search for a polygon "
      "with few edges; auto: the search first, then the flow to an even, smooth shape");
  command
      .add_option("--chains", parameters.number_of_chains,
                  "chains of random moves side by side, which share the threads; that with the "
                  "fewest moves gives the result")
      ->check(CLI::Range(std::size_t(1), max_chains).description(""))
      ->capture_default_str()
      ->type_name("N");
  add_seed_option(command, parameters.random_seed, "seed of the random search");
  add_number(command, "--thickness", parameters.thickness,
             "r, about the strand distance in the tight curve, in the input's unit; default: "
             "the 25th percentile of the medial radii")
      .type_name("R");
  add_number(command, "--bend-radius", parameters.bend_radius,
             "least radius of bends in the result; r grows to R / 0.75")
      .type_name("R");
  add_number(command, "--strand-distance", parameters.strand_distance,
             "least strand distance in the result; r grows to D / 0.95")
      .type_name("D");
  add_flow_options(command, parameters);
}

} // namespace vfc
