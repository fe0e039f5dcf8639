// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/Command_line.h"

#include "options/numbers.h"
#include "reports/versions.h"

#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace vfc {
namespace {

constexpr char jobs[] =
    "Moves curves without letting them pass through themselves, certified by exact predicates:\n"
    "  vfc untangle knot.obj -o tight.obj    brings a knot or link to a short and simple shape\n"
    "  vfc fill mesh.off -o curve.obj        fills the inside of a closed surface with a curve";

constexpr char examples[] =
    "Lengths are in the unit of the input. Curves are .obj (v and l), .polylines.txt, .ply\n"
    "and .vtp with lines, .vect, .xyz, .txt, .dat or (for reading) .pdb, .ent, .cif files.\n"
    "\n"
    "Exit status: 0 goal reached, 1 wrong options or files, 2 a limit, a partial filling, or a\n"
    "length or constraint not reached, 3 stalled, 4 invalid input, 5 interrupted.\n"
    "\n"
    "Examples:\n"
    "  vfc generate torus-knot --p 2 --q 3 -o trefoil.obj\n"
    "  vfc untangle trefoil.obj -o tight.obj --report tight.json\n"
    "  vfc draw tight.obj -o tight.svg\n"
    "  vfc fill mesh.off --thickness 0.05 -o curve.obj --report curve.json\n"
    "  vfc measure curve.obj mesh.off --thickness 0.05";

const std::string extensions_of_curves =
    ".obj, .polylines.txt, .ply, .vtp, .vect, .xyz, .txt, .dat, .pdb, .ent or .cif";

constexpr std::size_t text_column = 34, page_width = 100;

// Breaks the lines of descriptions between words, and ends the last line.
class Wrapping_formatter : public CLI::Formatter
{
public:
  std::string make_option_desc(const CLI::Option* option) const override
  {
    std::istringstream words(CLI::Formatter::make_option_desc(option));
    std::string text;
    std::size_t width = 0;
    for(std::string word; words >> word; width += word.size() + 1) {
      const bool is_full = width + word.size() > page_width - text_column;
      if(width > 0) text += is_full ? '\n' : ' ';
      if(is_full) width = 0;
      text += word;
    }
    return text;
  }

  // A command shows its first group unless all are requested.
  std::string make_help(const CLI::App* app,
                        std::string name,
                        CLI::AppFormatMode mode) const override
  {
    const std::vector<std::string> groups = app->get_groups();
    if(mode != CLI::AppFormatMode::Normal || app->get_parent() == nullptr || groups.size() < 2)
      return CLI::Formatter::make_help(app, name, mode);
    const auto is_shown = [&](const CLI::Option* option) {
      return option->get_group() == groups.front() && option->nonpositional();
    };
    std::string more;
    for(std::size_t k = 1; k < groups.size(); ++k) more += (k > 1 ? ", " : "") + groups[k];
    return make_description(app) + make_usage(app, name) + make_positionals(app) +
           make_group(groups.front(), false, app->get_options(is_shown)) + "\nMore options (" +
           more + "): vfc " + app->get_name() + " --help-all\n";
  }

  std::string make_footer(const CLI::App* app) const override
  {
    const std::string text = CLI::Formatter::make_footer(app);
    return text.empty() ? text : text + '\n';
  }
};

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

CLI::Validator file_check()
{
  return CLI::Validator(
      [](std::string& file) { return file.empty() ? "a value is missing" : std::string(); }, "");
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

void add_common_options(CLI::App& command, Common_options& options)
{
  const std::size_t max_threads = 1024;
  add_file(command, "--report", options.report,
           "JSON report; - prints it instead of the summary, on standard output");
  add_whole_number(command, "--threads", options.threads,
                   "number of threads, which does not change the result; default: all", 1,
                   max_threads);
  CLI::Option* const quiet =
      command.add_flag("--quiet", options.is_quiet, "only errors: no progress, warnings, summary");
  command.add_flag("--verbose", options.is_verbose, "a line for every iteration")->excludes(quiet);
  command.add_flag("--force", options.may_overwrite,
                   "overwrite existing files; without it they are an error");
}

} // namespace

Command_line::Command_line() : program(jobs, "vfc")
{
  program.set_version_flag("--version", all_versions());
  program.set_help_all_flag("--help-all", "Print this help with all options and exit");
  const auto formatter = std::make_shared<Wrapping_formatter>();
  formatter->column_width(text_column);
  program.formatter(formatter);
  program.footer(examples);
  program.require_subcommand(1);
}

CLI::App& Command_line::add_command(const std::string& command_name,
                                    const std::string& description,
                                    Command run)
{
  CLI::App& added = *program.add_subcommand(command_name, description);
  add_common_options(added, options);
  added.final_callback([this, command_name, run = std::move(run)] {
    name = command_name;
    command = run;
  });
  return added;
}

CLI::Option& add_file(CLI::App& command,
                      const std::string& name,
                      std::string& file,
                      const std::string& description)
{
  return *command.add_option(name, file, description)->check(file_check())->type_name("FILE");
}

CLI::Option& add_curve(CLI::App& command, std::string& file)
{
  return *add_file(command, "CURVE", file, "the curve, " + extensions_of_curves).required();
}

CLI::Option& add_curves(CLI::App& command, std::vector<std::string>& files)
{
  return *command.add_option("CURVE", files, "the curve, or several, " + extensions_of_curves)
              ->check(file_check())
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
              ->check(file_check())
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
