// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SHARED_OPTIONS_H
#define VFC_SHARED_OPTIONS_H

#include "files/checkpoints.h"
#include "files/curve_files.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>

#include <cstddef>
#include <string>

namespace CLI {
class App;
}

namespace vfc {

// Groups of options that several commands have; defaults are those of the package.

// Outputs other than the curve.
struct Film_options
{
  std::string map, frames;
  std::size_t every = 1;
  std::string frame_format = "obj"; // or "vtp"
};

// Permissions: kinds of curves, and nodes that move.
struct Curve_options
{
  std::string pin;
  Curve_reading reading;
  bool has_free_ends = false;
};

void add_film_options(CLI::App& command, Film_options& options);
void add_checkpoint_options(CLI::App& command, Checkpoint_options& options);
void add_curve_options(CLI::App& command, Curve_options& options);
// All but the tolerance, which not every command has.
void add_stop_options(CLI::App& command,
                      CGAL::Volume_filling_curves::Curve_run_parameters& parameters);
void add_seed_option(CLI::App& command, std::size_t& seed, const std::string& description);

// All but the thickness, whose default differs.
void add_flow_options(CLI::App& command,
                      CGAL::Volume_filling_curves::Curve_flow_parameters& parameters);

} // namespace vfc

#endif // VFC_SHARED_OPTIONS_H
