// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc check: lists every defect of a curve.

#include "Command_line.h"
#include "Exit_status.h"
#include "commands.h"
#include "curve_files.h"

#include <cstddef>
#include <memory>
#include <string>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

struct Check_options
{
  std::string file;
  bool is_network = false;
};

Report::Json to_json(const curves::Curve_defect& defect, const std::string& file)
{
  Report::Json json = {{"kind", curves::to_string(defect.kind)},
                       {"severity", curves::is_error(defect.kind) ? "error" : "warning"},
                       {"file", file},
                       {"line", nullptr},
                       {"nodes", defect.nodes},
                       {"component", nullptr},
                       {"message", defect.message}};
  if(defect.line > 0) json["line"] = defect.line;
  if(defect.component > 0) json["component"] = defect.component;
  return json;
}

// Prints and reports the defects; returns the number of errors.
std::size_t list(Session& session, const std::string& file, const Input_error::Defects& defects)
{
  Report::Json& listed = session.report()["defects"] = Report::Json::array();
  std::size_t number_of_errors = 0;
  for(const curves::Curve_defect& defect : defects) {
    session.print_result(curves::to_string(defect, file) + '\n');
    listed.push_back(to_json(defect, file));
    if(curves::is_error(defect.kind)) ++number_of_errors;
  }
  return number_of_errors;
}

int check(Session& session, const Check_options& options)
{
  Report& report = session.report();
  report["input"] = options.file;
  const Curve_and_defects read = read_curve_and_defects(options.file, options.is_network);
  session.end_stage("checking");
  const std::size_t errors = list(session, options.file, read.defects);
  session.console().note(options.file + ": errors: " + std::to_string(errors) +
                         ", warnings: " + std::to_string(read.defects.size() - errors));
  if(!read.is_valid) {
    report.set_error(Input_error(options.file, read.defects));
    return INVALID_INPUT;
  }
  report["components"] = read.curve.number_of_components();
  report["nodes_start"] = read.curve.number_of_nodes();
  report["status"] = "done";
  return GOAL_REACHED;
}

} // namespace

void add_check_command(Command_line& command_line)
{
  const auto options = std::make_shared<Check_options>();
  CLI::App& command =
      command_line.add_command("check", "list every defect of a curve",
                               [options](Session& session) { return check(session, *options); });
  add_curve(command, options->file);
  add_network_flag(command, options->is_network);
  command.footer("Prints a line per defect: FILE:LINE: error|warning: KIND: message (nodes i j).\n"
                 "Exit status: 0 no error found, 4 errors found.");
}

} // namespace vfc
