// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc identify: the knots and links that closed curves and open chains form.

#include "commands/commands.h"
#include "files/curve_files.h"
#include "identification/identify_curves.h"
#include "options/Command_line.h"
#include "options/option_kinds.h"
#include "options/shared_options.h"
#include "reports/chain_report.h"
#include "reports/report_rows.h"
#include "session/Exit_status.h"
#include "session/errors.h"
#include "session/run_command.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vfc {
namespace {

bool is_open_everywhere(const Curve& curve)
{
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(curve.is_closed(c)) return false;
  return curve.number_of_components() > 0 && !curve.has_junction();
}

void print_details(const Session& session, const Report& report)
{
  for(const Report::Json& chain : report["chains"]) session.print_result(chain_details(chain));
  if(!report["chains"].is_null()) return;
  for(const std::string key :
      {"components", "knottedness", "crossings", "writhe", "determinant", "signature",
       "alexander_polynomial", "homfly_polynomial", "jones_polynomial"})
    session.print_result(row(key, report[key]));
  if(report["components"] > 1)
    session.print_result(row("linking_matrix", report["linking_matrix"]));
  for(const auto& [kind, code] : report["codes"].items()) session.print_result(row(kind, code));
}

// Identifies a file, and returns the lines with the names.
std::string identify_file(Session& session,
                          const std::string& file,
                          const Identify_options& options)
{
  session.report()["input"] = file;
  const Curve curve = read_curve(session, file, options.reading);
  const auto identify = is_open_everywhere(curve) ? identify_chains : identify_link;
  const std::string names = identify(session, curve, file, options);
  session.report()["status"] = "done";
  return names;
}

// Identifies each file in a session of its own, whose report is an item of the report: a file with
// a fault does not keep the others from being identified. Status and error of the report are those
// of the file with the most severe exit status, which is returned.
int identify_each(Session& session, Common_options common, const Identify_options& options)
{
  if(!options.fingerprint.empty()) throw Usage_error("--fingerprint: is for a single CURVE");
  common.report.clear();
  Report& report = session.report();
  report["curves"] = Report::Json::array();
  int status = GOAL_REACHED;
  for(const std::string& file : options.files) {
    Session single("identify", common);
    single.promise_report();
    const int own_status = run_command(single, [&](Session& own) {
      session.print_result(identify_file(own, file, options));
      return GOAL_REACHED;
    });
    report["curves"].push_back(Report::Json::parse(single.report().to_line()));
    const int former = std::exchange(status, more_severe(status, own_status));
    if(report["status"].is_null() || status != former)
      for(const std::string key : {"status", "error"}) report[key] = single.report()[key];
    if(own_status == INTERRUPTED) break;
  }
  session.end_stage("identifying");
  return status;
}

int run(Session& session, const Command_line& command_line, const Identify_options& options)
{
  if(!options.fingerprint.empty()) check_fingerprint(options.fingerprint);
  for(const std::string& file : options.files) session.add_input(file);
  session.outputs().add("--fingerprint", options.fingerprint);
  if(options.files.size() > 1) return identify_each(session, command_line.options, options);
  const std::string names = identify_file(session, options.files[0], options);
  if(!command_line.batch.list.empty()) {
    session.print_summary(names);
    return GOAL_REACHED;
  }
  session.print_result(names);
  print_details(session, session.report());
  return GOAL_REACHED;
}

void add_chain_options(CLI::App& command, Identify_options& options)
{
  constexpr std::size_t max_closures = 1000000;
  add_whole_number(command, "--closures", options.chain.closures,
                   "directions in which an open chain is closed", 1, max_closures)
      .capture_default_str();
  command.add_flag("--core", options.chain.find_core,
                   "look for the core: a short section with the knot of the chain");
  add_file(command, "--fingerprint", options.fingerprint,
           "the knots of all sections of the chain, .svg, .png or .csv; finds slipknots");
  add_whole_number(command, "--stride", options.chain.stride,
                   "edges between the ends of the sections; default: a 60th of the chain", 1)
      .needs(command.get_option("--fingerprint"));
  add_seed_option(command, options.chain.random_seed, "seed of the directions");
}

} // namespace

void add_identify_command(Command_line& command_line)
{
  const auto options = std::make_shared<Identify_options>();
  CLI::App& command = command_line.add_command(
      "identify", "name the knots and links that closed curves and open chains form",
      [options, &command_line](Session& session) { return run(session, command_line, *options); });
  CLI::Option& curves = add_curves(command, options->files);
  command
      .add_option("--codes", options->codes,
                  "write the diagram: pd, gauss or dt, or several of them with commas")
      ->delimiter(',')
      ->check(CLI::IsMember({"pd", "gauss", "dt"}).description(""))
      ->type_name("NAMES");
  add_number(command, "--time-limit", options->time_limit,
             "time after which each file ends without a result; default: none", not_negative)
      .type_name("SECONDS");
  add_reading_flags(command, options->reading);
  add_chain_options(command, *options);
  add_file(command, "-o,--output", options->folder, "folder of a batch")
      .type_name("DIR")
      ->group("Many runs");
  add_batch_options(command, curves,
                    {&options->files.front(), &options->folder, {&options->fingerprint}},
                    command_line, false);
  command.footer(
      "Prints the name of the knot, (proved) or consistent with its polynomials; then keys of the\n"
      "report, with - for unknown values. All values are exact: they are those of a diagram that\n"
      "was projected with exact predicates and simplified by Reidemeister moves.\n"
      "  name                  in Rolfsen's table, up to 10 crossings, for links up to 6;\n"
      "                        * for the mirror image\n"
      "  knottedness           what is proved, and by which invariant\n"
      "  crossings             of the diagram; the knot has no more\n"
      "  signature             -2 for the right-handed trefoil\n"
      "  alexander_polynomial  coefficients from the lowest power on, of at most 300 crossings\n"
      "  dt                    does not determine the mirror image; an error for links, status 4\n"
      "\n"
      "An open chain is closed in many directions; the name is that of the most frequent knot:\n"
      "  share_of_NAME         of the closures, with the standard error of N random ones\n"
      "  direct                the knot if a segment joins the ends\n"
      "  least_interfering     the same or, if shorter, by paths out of the convex hull\n"
      "  core                  the first and the last node, counted along the chain from 1\n"
      "  slipknot              section that forms another knot than the chain in most closures\n"
      "For several CURVEs, only the names are printed; the report lists their reports in curves.");
}

} // namespace vfc
