// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc identify: what knot or link closed curves form.

#include "commands/commands.h"
#include "files/curve_files.h"
#include "options/Command_line.h"
#include "options/shared_options.h"
#include "reports/knot_report.h"
#include "reports/report_rows.h"
#include "session/Exit_status.h"
#include "session/No_result.h"
#include "session/Patience.h"
#include "session/errors.h"
#include "session/interruption.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

struct Identify_options
{
  std::string file;
  std::vector<std::string> codes;
  Curve_reading reading;
};

std::string diagram_code(const std::string& kind, const curves::Planar_diagram& diagram)
{
  if(kind == "pd") return curves::pd_code(diagram);
  return kind == "gauss" ? curves::gauss_code(diagram) : curves::dt_code(diagram);
}

// Curve whose components are all closed and do not branch
Curve read_closed_curve(Session& session, const Identify_options& options)
{
  Curve curve = read_curve(session, options.file, options.reading);
  Defects defects;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(!curve.is_closed(c))
      defects.emplace_back("open component", options.file, std::vector<std::size_t>{}, c + 1,
                           "component " + std::to_string(c + 1) + " is not a closed curve");
  if(!defects.empty()) throw Input_error(std::move(defects), "a knot or link");
  return curve;
}

curves::Planar_diagram diagram_of_input(Session& session, const Identify_options& options)
{
  const Curve curve = read_closed_curve(session, options);
  session.report()["components"] = curve.number_of_components();
  poll_interruptions();
  try {
    return diagram_of(curve, Patience());
  } catch(const curves::Run_interrupted&) {
    throw No_result(INTERRUPTED, options.file + ": interrupted, while its diagram was made");
  }
}

int run(Session& session, const Identify_options& options)
{
  Report& report = session.report();
  report["input"] = options.file;
  session.add_input(options.file);
  const auto diagram = diagram_of_input(session, options);
  session.end_stage("projecting");
  report_diagram(report, diagram);
  if(!options.codes.empty()) report["codes"] = Report::Json::object();
  for(const std::string& kind : options.codes) report["codes"][kind] = diagram_code(kind, diagram);
  session.end_stage("measuring");
  report["status"] = "done";
  for(const std::string key : {"components", "knottedness", "crossings", "writhe", "determinant",
                               "signature", "alexander_polynomial"})
    session.print_result(row(key, report[key]));
  for(const std::string& kind : options.codes)
    session.print_result(row(kind, report["codes"][kind]));
  return GOAL_REACHED;
}

} // namespace

void add_identify_command(Command_line& command_line)
{
  const auto options = std::make_shared<Identify_options>();
  CLI::App& command =
      command_line.add_command("identify", "what knot or link closed curves form",
                               [options](Session& session) { return run(session, *options); });
  add_curve(command, options->file);
  command
      .add_option("--codes", options->codes,
                  "write the diagram: pd, gauss or dt, or several of them with commas")
      ->delimiter(',')
      ->check(CLI::IsMember({"pd", "gauss", "dt"}).description(""))
      ->type_name("NAMES");
  add_reading_flags(command, options->reading);
  command.footer(
      "Prints the keys of the report, - for what is not known. All of them are exact: they are\n"
      "those of a diagram of CURVE that was projected with exact predicates and simplified by\n"
      "Reidemeister moves.\n"
      "  knottedness           what is proved, and by which invariant\n"
      "  crossings             of the diagram; the knot has no more\n"
      "  signature             -2 for the right-handed trefoil\n"
      "  alexander_polynomial  coefficients from the lowest power on, of at most 300 crossings\n"
      "  dt                    leaves the mirror image open, and is for knots only");
}

} // namespace vfc
