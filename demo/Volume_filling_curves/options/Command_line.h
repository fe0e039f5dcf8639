// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_COMMAND_LINE_H
#define VFC_COMMAND_LINE_H

#include "options/batch_options.h"
#include "session/Session.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace vfc {

// Command line and its options. Each command has a file that adds it, with its options.
struct Command_line
{
  using Command = std::function<int(Session&)>; // returns the exit status

  Command_line();

  // Adds a command that runs the function, and the options that all commands have.
  CLI::App& add_command(const std::string& name, const std::string& description, Command command);

  CLI::App program;
  std::string name; // of the command that was given, empty before parsing
  Command command;
  Common_options options;
  Batch_options batch;
  File_options files; // of the command, if it can run in batches
};

} // namespace vfc

#endif // VFC_COMMAND_LINE_H
