// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/shared_options.h"

#include "options/option_kinds.h"

namespace vfc {
using CGAL::Volume_filling_curves::Curve_flow_parameters;
using CGAL::Volume_filling_curves::Curve_run_parameters;
using CGAL::Volume_filling_curves::Preconditioner;

void add_film_options(CLI::App& command, Film_options& options)
{
  add_file(command, "--map", options.map,
           "for each node of the result, a line with its number in CURVE, 0 for a new node");
  CLI::Option& frames =
      add_file(command, "--frames", options.frames, "folder for the curve of every K-th iteration");
  frames.type_name("DIR");
  add_whole_number(command, "--every", options.every, "K, the iterations between two frames", 1)
      .capture_default_str()
      ->needs(&frames);
  command
      .add_option("--frame-format", options.frame_format,
                  "obj; or vtp, with origin, component and curvature of each node and a list "
                  "frames.pvd, which ParaView plays as a film")
      ->check(CLI::IsMember({"obj", "vtp"}).description(""))
      ->capture_default_str()
      ->type_name("NAME")
      ->needs(&frames);
}

void add_checkpoint_options(CLI::App& command, Checkpoint_options& options)
{
  CLI::Option& checkpoint = add_file(
      command, "--checkpoint", options.checkpoint,
      "state of the run for --resume, written at intervals, on interruption and at a limit");
  add_number(command, "--save-every", options.save_every, "seconds between two states",
             not_negative)
      .capture_default_str()
      ->needs(&checkpoint)
      ->type_name("SECONDS");
  add_file(command, "--resume", options.resume,
           "state to resume from; input and options must be the same, except for limits and "
           "outputs; the result is that of an uninterrupted run");
}

void add_curve_options(CLI::App& command, Curve_options& options)
{
  add_reading_flags(command, options.reading);
  add_text(command, "--pin", options.pin,
           "pinned nodes: ends, or numbers i,j,k in file order from 1, in addition to OBJ lines "
           "'fixed i j k'")
      .type_name("NODES");
  command.add_flag("--free-ends", options.has_free_ends, "do not pin the ends of open curves");
}

void add_stop_options(CLI::App& command, Curve_run_parameters& parameters)
{
  add_number(command, "--time-limit", parameters.time_limit,
             "end the run after this time and write the current curve; default: none", not_negative)
      .type_name("SECONDS");
  add_whole_number(command, "--max-iterations", parameters.number_of_iterations,
                   "the largest number of iterations", 0)
      .capture_default_str();
}

void add_seed_option(CLI::App& command, std::size_t& seed, const std::string& description)
{
  add_whole_number(command, "--seed", seed, description, 0).capture_default_str();
}

void add_flow_options(CLI::App& command, Curve_flow_parameters& parameters)
{
  const std::size_t max_directions = 1024;
  add_whole_number(command, "--directions", parameters.number_of_directions,
                   "medial spheres per node", 1, max_directions)
      .capture_default_str();
  add_number(command, "--rmax", parameters.max_radius, "largest medial radius, in units of r",
             positive_ratio)
      .capture_default_str();
  add_number(command, "--spacing", parameters.spacing,
             "least length h of an edge, in units of r; edges longer than 2 h are split",
             positive_share)
      .capture_default_str();
  add_number(command, "--lambda", parameters.screening, "locality of the flow, in units of 1/r^2",
             positive_ratio)
      .capture_default_str();
  // The paper's preconditioner alone has it. A --preconditioner, which is read later, is kept.
  add_number(command, "--beta", parameters.coupling,
             "coupling along medial spheres, dimensionless; implies --preconditioner medial", ratio)
      .each([&](const std::string&) { parameters.preconditioner = Preconditioner::MEDIAL; })
      ->capture_default_str();
  add_number(command, "--tau", parameters.time_step,
             "the paper's fixed time step, dimensionless; default: adaptive", positive_ratio);
  add_choice(command, "--preconditioner", parameters.preconditioner,
             {{"medial", Preconditioner::MEDIAL},
              {"h1", Preconditioner::H1},
              {"l2", Preconditioner::L2},
              {"quasi-newton", Preconditioner::QUASI_NEWTON},
              {"contact", Preconditioner::CONTACT}},
             "medial, h1, l2, quasi-newton or contact")
      .default_str(to_string(parameters.preconditioner));
}

} // namespace vfc
