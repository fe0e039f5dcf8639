// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CHECKPOINTS_H
#define VFC_CHECKPOINTS_H

#include "session/errors.h"

#include <CGAL/Volume_filling_curves/internal/state/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>

#include <string>

namespace vfc {

class Session;

// Files that the state of a run is written to and read from.
struct Checkpoint_options
{
  std::string checkpoint, resume; // files, or empty
  double save_every = 60;         // seconds
};

// Checks the files. \throws Usage_error
void plan_checkpoints(Session& session, const Checkpoint_options& options);

// Runs. \throws Input_error if the state to resume from is rejected
template <typename Run>
auto resume(const Checkpoint_options& options, const Run& run)
{
  try {
    return run();
  } catch(const CGAL::Volume_filling_curves::Run_state_error& error) {
    throw Input_error({{"state rejected", options.resume, {}, 0, error.what()}},
                      "a state to resume from");
  }
}

// Returns the state to resume from, empty if there is none. \throws Input_error
CGAL::Volume_filling_curves::Run_state read_run_state(const Checkpoint_options& options);

// Makes a run write its state at intervals, and where it ends early; each state replaces the former
// one. Warns if that is impossible.
void save_states(const Session& session,
                 CGAL::Volume_filling_curves::Curve_run_parameters& parameters,
                 const Checkpoint_options& options);

} // namespace vfc

#endif // VFC_CHECKPOINTS_H
