// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_COMMAND_LINE_H
#define VFC_COMMAND_LINE_H

#include "Session.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>

namespace vfc {

// The command line and what it asks for. Each command has a file that adds it, with its options.
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
};

// An argument or a flag of a command.
CLI::Option& add_curve(CLI::App& command, std::string& file);
void add_network_flag(CLI::App& command, bool& is_network);

// Options with a number; they refuse everything else, and tell their name.
CLI::Option& add_number(CLI::App& command,
                        const std::string& name,
                        double& number,
                        const std::string& description,
                        bool may_be_zero = false);
CLI::Option& add_whole_number(CLI::App& command,
                              const std::string& name,
                              std::size_t& number,
                              const std::string& description,
                              std::size_t least,
                              std::size_t most = std::numeric_limits<std::size_t>::max());

} // namespace vfc

#endif // VFC_COMMAND_LINE_H
