// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/complaint.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace vfc {
namespace {

// The optimal string alignment distance, row by row.
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> before_last, last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for(std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last = row;
    row[0] = i;
    for(std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = (std::min)({last[j] + 1, row[j - 1] + 1, replaced});
      if(i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = (std::min)(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

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

std::string meant_name(const std::string& typed, const std::vector<std::string>& names)
{
  std::string closest;
  std::size_t least = typed.size();
  for(const std::string& name : names) {
    const std::size_t distance = edit_distance(typed, name);
    if(3 * distance > name.size() || distance >= least) continue;
    least = distance;
    closest = name;
  }
  return closest;
}

std::string complaint(const CLI::ParseError& error,
                      const CLI::App& program,
                      const std::vector<std::string>& arguments)
{
  if(program.get_subcommands().empty()) return complaint_about_command(program, arguments);
  const bool is_about_rest = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  return is_about_rest ? complaint_about_rest(program) : error.what();
}

} // namespace vfc
