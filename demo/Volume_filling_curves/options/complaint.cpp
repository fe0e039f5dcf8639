// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/complaint.h"

#include "options/meant_name.h"

namespace vfc {
namespace {

// Empty, or "; did you mean NAME?".
std::string question(const std::string& typed, const std::vector<std::string>& names)
{
  const std::string name = meant_name(typed, names);
  return name.empty() ? name : "; did you mean " + name + '?';
}

std::string complaint_about_command(const CLI::App& program,
                                    const std::vector<std::string>& arguments)
{
  if(arguments.empty()) return "a command is missing; vfc --help lists them";
  std::vector<std::string> names;
  for(const CLI::App* command : program.get_subcommands(nullptr))
    names.push_back(command->get_name());
  const std::string meant = question(arguments.front(), names);
  return "there is no command '" + arguments.front() + '\'' + meant +
         (meant.empty() ? "; vfc --help lists them" : " vfc --help lists all");
}

std::vector<std::string> names_of_options(const CLI::App& command)
{
  std::vector<std::string> names;
  for(const CLI::Option* option : command.get_options())
    for(const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// In the order in which they were given; the error itself has them reversed (CLI11 2.1).
std::string complaint_about_rest(const CLI::App& program)
{
  std::string complaint = "not expected:", meant;
  const std::vector<std::string> names = names_of_options(*program.get_subcommands().front());
  for(const std::string& argument : program.remaining(true)) {
    complaint += ' ' + argument;
    if(meant.empty()) meant = question(argument.substr(0, argument.find('=')), names);
  }
  return complaint + meant;
}

} // namespace

std::string complaint(const CLI::ParseError& error,
                      const CLI::App& program,
                      const std::vector<std::string>& arguments)
{
  if(program.get_subcommands().empty()) return complaint_about_command(program, arguments);
  const bool is_about_rest = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  return is_about_rest ? complaint_about_rest(program) : error.what();
}

} // namespace vfc
