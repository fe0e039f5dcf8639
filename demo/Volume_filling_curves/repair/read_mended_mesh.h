// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_READ_MENDED_MESH_H
#define VFC_READ_MENDED_MESH_H

#include "files/mesh_files.h"
#include "session/No_result.h"
#include "session/Work_watch.h"

#include <limits>
#include <string>

namespace vfc {

struct Mending_options
{
  double alpha = 0;                                            // see repair_mesh()
  double time_limit = std::numeric_limits<double>::infinity(); // in seconds of the session
};

// Reads a mesh, and mends it by repair_mesh() if it has errors and all of them can be mended.
// Reports the repairs to the user and in the report, also if there are none. \throws Input_error
// \throws No_result if the time is over or the user interrupts
Mesh_and_defects read_mended_mesh(Session& session,
                                  const std::string& file,
                                  const Mending_options& options);

// Returns the exception for work on a file that was stopped by its watch: interrupted, or at the
// time limit.
No_result unfinished(const Work_watch& watch, const std::string& file, double time_limit);

} // namespace vfc

#endif // VFC_READ_MENDED_MESH_H
