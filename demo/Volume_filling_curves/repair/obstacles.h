// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_OBSTACLES_H
#define VFC_OBSTACLES_H

#include "files/mesh_files.h"

#include <string>
#include <vector>

namespace vfc {

// Reads obstacles and adds them to a mesh, whose vertices keep their positions. \throws Input_error
// if they cannot be read, or an obstacle is not strictly inside and apart from all others
void add_obstacles(Session& session, Mesh& mesh, const std::vector<std::string>& files);

// Reads obstacles, mends them and adds them to a mesh; those that cross the mesh or other obstacles
// are cut out. The time limit is in seconds of the session. \throws Input_error if they cannot be
// read, if an obstacle is outside, or within or around another one, or if the remainder is empty or
// touches itself \throws No_result if the time is over or the user interrupts
void add_or_cut_out_obstacles(Session& session,
                              Mesh& mesh,
                              const std::vector<std::string>& files,
                              double time_limit);

} // namespace vfc

#endif // VFC_OBSTACLES_H
