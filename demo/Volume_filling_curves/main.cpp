// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The program vfc. Finds out which command is meant and runs it, once or for each input of a batch.

#include "batch/run_batch.h"
#include "commands/commands.h"
#include "options/Command_line.h"
#include "options/complaint.h"
#include "options/option_groups.h"
#include "reports/versions.h"
#include "session/Console.h"
#include "session/errors.h"
#include "session/interruption.h"
#include "session/run_command.h"
#include "session/standard_streams.h"

#include "commit.h"

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace vfc {
namespace {

// Returns the word after an option on a command line that could not be parsed.
std::string value_of(const std::string& option, const std::vector<std::string>& arguments)
{
  for(std::size_t i = 0; i < arguments.size(); ++i) {
    if(arguments[i] == option) return i + 1 < arguments.size() ? arguments[i + 1] : "";
    if(arguments[i].compare(0, option.size() + 1, option + '=') == 0)
      return arguments[i].substr(option.size() + 1);
  }
  return "";
}

// Any argument may name an input, which the report must not replace.
void add_inputs(Session& session, const std::vector<std::string>& arguments)
{
  for(std::size_t i = 0; i < arguments.size(); ++i)
    if(i == 0 || arguments[i - 1] != "--report") session.add_input(arguments[i]);
}

// A script that asks for a report gets one even if it uses wrong options.
int refuse(const std::vector<std::string>& arguments, const std::string& message)
{
  Common_options options;
  options.report = value_of("--report", arguments);
  options.may_overwrite =
      std::find(arguments.begin(), arguments.end(), "--force") != arguments.end();
  Session session(arguments.empty() ? "" : arguments.front(), options);
  try {
    session.start_report();
    add_inputs(session, arguments);
  } catch(const Usage_error&) {
    // the first error is reported
  }
  return fail(session, FAILURE, message);
}

// Prints the help or the version that an option asked for.
int print_help(const CLI::App& program, const CLI::ParseError& request)
{
  const int status = program.exit(request);
  if(std::cout.flush()) return status;
  Console(Verbosity::NORMAL).fail("standard output cannot be written");
  return FAILURE;
}

int run(const Command_line& command_line)
{
  Session session(command_line.name, command_line.options);
  if(command_line.batch.list.empty()) return run_command(session, command_line.command);
  const auto run_all = [&](Session& all) { return run_batch(command_line, all); };
  return run_command(session, run_all);
}

int run_program(int argc, char** argv)
{
  reserve_standard_streams();
  handle_signals();
  set_commit(vfc_commit);
  Command_line command_line;
  add_untangle_command(command_line);
  add_simplify_command(command_line);
  add_fill_command(command_line);
  add_check_command(command_line);
  add_measure_command(command_line);
  add_identify_command(command_line);
  add_repair_command(command_line);
  add_generate_command(command_line);
  add_convert_command(command_line);
  add_draw_command(command_line);
  for(CLI::App* const command : command_line.program.get_subcommands({})) group_options(*command);
  try {
    command_line.program.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    if(error.get_exit_code() == 0) return print_help(command_line.program, error);
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    return refuse(arguments, complaint(error, command_line.program, arguments));
  }
  return run(command_line);
}

} // namespace
} // namespace vfc

int main(int argc, char** argv)
{
  return vfc::run_program(argc, argv);
}
