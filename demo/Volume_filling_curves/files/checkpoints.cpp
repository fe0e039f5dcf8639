// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/checkpoints.h"

#include "files/Output_files.h"
#include "files/read_finite_file.h"
#include "reports/versions.h"
#include "session/Session.h"

#include <system_error>
#include <utility>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

void plan_checkpoints(Session& session, const Checkpoint_options& options)
{
  if(!options.resume.empty()) session.add_input(options.resume, "--checkpoint");
  session.outputs().add_continued("--checkpoint", options.checkpoint, options.resume);
}

curves::Run_state read_run_state(const Checkpoint_options& options)
{
  if(options.resume.empty()) return {};
  return resume(options, [&] {
    std::string content;
    if(const std::error_code error = read_finite_file(options.resume, content))
      throw curves::Run_state_error(error.message());
    return curves::Run_state(std::move(content));
  });
}

void save_states(const Session& session,
                 curves::Curve_run_parameters& parameters,
                 const Checkpoint_options& options)
{
  parameters.build_name = commit();
  if(options.checkpoint.empty()) return;
  parameters.checkpoint = [&session, options, last = session.seconds(),
                           is_kept = false](const auto& checkpoint) mutable {
    const bool is_due = checkpoint.is_last || session.seconds() - last >= options.save_every;
    if(is_kept || !is_due) return;
    try {
      Output_files::write(options.checkpoint, checkpoint.state().bytes());
    } catch(const Usage_error& error) { // the curve is worth more than the state
      is_kept = dynamic_cast<const Kept_file*>(&error) != nullptr; // of another run
      session.console().warn(error.what());
    }
    last = session.seconds();
  };
}

} // namespace vfc
