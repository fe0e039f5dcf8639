// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/Command_line.h"

#include "options/option_kinds.h"
#include "reports/versions.h"

#include <cstddef>
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

} // namespace vfc
