// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_RUN_COMMAND_H
#define VFC_RUN_COMMAND_H

#include "session/Exit_status.h"

#include <functional>
#include <string>

namespace vfc {

class Session;

// Runs a command, turns errors into messages, a report and an exit status, and returns the latter.
int run_command(Session& session, const std::function<int(Session&)>& command);

// Prints and reports the error, and returns the exit status.
int fail(Session& session, Exit_status status, const std::string& message);

} // namespace vfc

#endif // VFC_RUN_COMMAND_H
