// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/option_kinds.h"

#include "options/numbers.h"

namespace vfc {
namespace {

const std::string extensions_of_curves =
    ".obj, .polylines.txt, .ply, .vtp, .vect, .xyz, .txt, .dat, .pdb, .ent or .cif";

std::string name_of(Range range)
{
  if(range.most < (std::numeric_limits<double>::max)())
    return "number from " + to_text(range.least) + " to " + to_text(range.most);
  return range.least > 0 ? "positive number" : "number of 0 or more";
}

CLI::Validator number_check(Range range)
{
  return CLI::Validator(
      [range](std::string& text) {
        double number = 0;
        if(parse(text, number) && number >= range.least && number <= range.most)
          return std::string();
        return "'" + text + "' is not a " + name_of(range);
      },
      "");
}

CLI::Validator text_check()
{
  return CLI::Validator(
      [](std::string& text) { return text.empty() ? "a value is missing" : std::string(); }, "");
}

CLI::Validator whole_number_check(std::size_t least, std::size_t most)
{
  return CLI::Validator(
      [least, most](std::string& text) {
        unsigned long long number = 0;
        if(parse(text, number) && number >= least && number <= most) return std::string();
        const bool has_most = most < std::numeric_limits<std::size_t>::max();
        return "'" + text + "' is not a whole number of " + std::to_string(least) +
               (has_most ? " to " + std::to_string(most) : " or more");
      },
      "");
}

} // namespace

CLI::Option& add_text(CLI::App& command,
                      const std::string& name,
                      std::string& text,
                      const std::string& description)
{
  return *command.add_option(name, text, description)->check(text_check());
}

CLI::Option& add_file(CLI::App& command,
                      const std::string& name,
                      std::string& file,
                      const std::string& description)
{
  return *add_text(command, name, file, description).type_name("FILE");
}

CLI::Option& add_curve(CLI::App& command, std::string& file)
{
  return *add_file(command, "CURVE", file, "the curve, " + extensions_of_curves).required();
}

CLI::Option& add_curves(CLI::App& command, std::vector<std::string>& files)
{
  return *command.add_option("CURVE", files, "the curve, or several, " + extensions_of_curves)
              ->check(text_check())
              ->type_name("FILE")
              ->required();
}

CLI::Option& add_mesh(CLI::App& command, std::string& file)
{
  return add_file(command, "MESH", file, "a closed triangle mesh, .off, .obj, .ply, .stl or .vtp");
}

CLI::Option& add_obstacle_option(CLI::App& command, std::vector<std::string>& files)
{
  return *command
              .add_option("--obstacle", files,
                          "closed surface inside the mesh, of any orientation, that the curve must "
                          "not enter; repeat the option for several obstacles")
              ->expected(1)
              ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
              ->check(text_check())
              ->type_name("FILE");
}

CLI::Option& add_curve_output(CLI::App& command, std::string& file)
{
  return add_file(
      command, "-o,--output", file,
      "the result, in any format of curves except .pdb and .cif; .ply and .vtp contain for "
      "each node its origin, component, curvature and, if r is known, medial radius");
}

void add_reading_flags(CLI::App& command, Curve_reading& reading)
{
  command.add_flag("--network", reading.is_network,
                   "accept junctions; equal ends in .polylines.txt are one node");
  CLI::Option& closed = *command.add_flag("--closed", reading.is_closed,
                                          "close each open curve by an edge between its ends");
  command.add_flag("--open", reading.is_open, "open each closed curve by dropping its last edge")
      ->excludes(&closed);
}

CLI::Option& add_number(CLI::App& command,
                        const std::string& name,
                        double& number,
                        const std::string& description,
                        Range range)
{
  return *command.add_option(name, number, description)->check(number_check(range))->type_name("X");
}

CLI::Option& add_whole_number(CLI::App& command,
                              const std::string& name,
                              std::size_t& number,
                              const std::string& description,
                              std::size_t least,
                              std::size_t most)
{
  return *command.add_option(name, number, description)
              ->check(whole_number_check(least, most))
              ->type_name("N");
}

} // namespace vfc
