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

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/identify.h>
#include <CGAL/Volume_filling_curves/knot_diagram.h>

#include <CLI/CLI.hpp>

#include <algorithm>
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

// \throws Input_error unless all components are closed
void check_closed(const Curve& curve, const std::string& file)
{
  Defects defects;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(!curve.is_closed(c))
      defects.emplace_back("open component", file, std::vector<std::size_t>{}, c + 1,
                           "component " + std::to_string(c + 1) + " is not a closed curve");
  if(!defects.empty()) throw Input_error(std::move(defects), "a knot or link");
}

// \throws Input_error if a link is to have a code that only knots have
void check_codes(const Curve& curve, const Identify_options& options)
{
  const auto& codes = options.codes;
  const bool needs_knot = std::find(codes.begin(), codes.end(), "dt") != codes.end();
  if(!needs_knot || curve.number_of_components() == 1) return;
  constexpr std::size_t second = 2; // component
  const Defect defect("several components", options.file, {}, second,
                      "only a knot has a Dowker-Thistlethwaite code");
  throw Input_error({defect}, "a knot");
}

curves::Link_identity identify_input(Session& session, const Identify_options& options)
{
  const Curve curve = read_curve(session, options.file, options.reading);
  check_closed(curve, options.file);
  check_codes(curve, options);
  session.report()["components"] = curve.number_of_components();
  poll_interruptions();
  try {
    const Patience patience;
    session.report()["linking_matrix"] =
        curves::linking_matrix(curve, curves::parameters::progress(patience));
    return curves::identify(curve, curves::parameters::progress(patience));
  } catch(const curves::Run_interrupted&) {
    throw No_result(INTERRUPTED, options.file + ": interrupted, while it was identified");
  }
}

void print_details(const Session& session, const Report& report)
{
  for(const std::string key :
      {"components", "knottedness", "crossings", "writhe", "determinant", "signature",
       "alexander_polynomial", "homfly_polynomial", "jones_polynomial"})
    session.print_result(row(key, report[key]));
  if(report["components"] > 1)
    session.print_result(row("linking_matrix", report["linking_matrix"]));
  for(const auto& [kind, code] : report["codes"].items()) session.print_result(row(kind, code));
}

int run(Session& session, const Identify_options& options)
{
  Report& report = session.report();
  report["input"] = options.file;
  session.add_input(options.file);
  const curves::Link_identity identity = identify_input(session, options);
  session.end_stage("identifying");
  report_identity(report, identity);
  for(const std::string& kind : options.codes)
    report["codes"][kind] = diagram_code(kind, identity.diagram);
  session.end_stage("measuring");
  report["status"] = "done";
  session.print_result(options.file + ": " + identity_text(identity) + '\n');
  print_details(session, report);
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
      "Prints the name of the knot, (proved) or consistent with its polynomials; then keys of the\n"
      "report, - for what is not known. All of them are exact: they are those of a diagram that\n"
      "was projected with exact predicates and simplified by Reidemeister moves.\n"
      "  name                  in Rolfsen's table, up to 10 crossings; * for the mirror image\n"
      "  knottedness           what is proved, and by which invariant\n"
      "  crossings             of the diagram; the knot has no more\n"
      "  signature             -2 for the right-handed trefoil\n"
      "  alexander_polynomial  coefficients from the lowest power on, of at most 300 crossings\n"
      "  dt                    leaves the mirror image open; of a link it is an error, status 4");
}

} // namespace vfc
