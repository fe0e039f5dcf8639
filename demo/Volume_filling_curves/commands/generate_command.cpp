// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc generate: knots, links and random polygons to try things with.

#include "commands/commands.h"
#include "files/curve_files.h"
#include "options/Command_line.h"
#include "options/numbers.h"
#include "options/option_kinds.h"
#include "reports/shape.h"
#include "session/Exit_status.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace vfc {
namespace {

namespace VFC = CGAL::Volume_filling_curves;

struct Generate_options
{
  std::string kind, output, word;
  int p = 2, q = 3;
  std::size_t nodes = 200, moves = 20000, seed = 0;
};

// A kind of curves, and the options that only this kind has.
struct Kind
{
  const char* name;
  std::vector<const char*> options;
  Curve (*generate)(const Generate_options& options);
};

Curve torus_knot(const Generate_options& options)
{
  return VFC::make_torus_knot(options.p, options.q, options.nodes, options.seed);
}

Curve braid(const Generate_options& options)
{
  const auto word = VFC::parse_braid_word(options.word);
  if(word.empty()) throw Usage_error("braid needs a --word such as \"1 -2 1 -2\"");
  return VFC::make_closed_braid(word, options.nodes, options.seed);
}

Curve random_polygon(const Generate_options& options)
{
  return VFC::make_random_polygon(options.nodes, options.seed);
}

Curve hard_unknot(const Generate_options& options)
{
  return VFC::make_hard_unknot(options.nodes, options.moves, options.seed);
}

const std::vector<Kind>& kinds()
{
  static const std::vector<Kind> all = {{"torus-knot", {"--p", "--q"}, torus_knot},
                                        {"braid", {"--word"}, braid},
                                        {"random-polygon", {}, random_polygon},
                                        {"hard-unknot", {"--moves"}, hard_unknot}};
  return all;
}

std::vector<std::string> names_of_kinds()
{
  std::vector<std::string> names;
  for(const Kind& kind : kinds()) names.push_back(kind.name);
  return names;
}

// \throws Usage_error if an option was given that the kind does not have
const Kind& find_kind(const CLI::App& command, const std::string& name)
{
  const Kind* found = nullptr;
  for(const Kind& kind : kinds())
    if(kind.name == name) found = &kind;
  for(const Kind& kind : kinds())
    for(const char* option : kind.options)
      if(&kind != found && command.count(option) > 0)
        throw Usage_error(std::string(option) + " is an option of " + kind.name + ", not of " +
                          name);
  return *found;
}

Curve make_curve(const Kind& kind, const Generate_options& options)
{
  try {
    const Curve curve = kind.generate(options);
    if(!VFC::is_embedded(curve)) throw std::invalid_argument("two edges of the curve meet");
    return curve;
  } catch(const std::invalid_argument& error) {
    throw Usage_error(std::string("generate ") + kind.name + ": " + error.what());
  }
}

int generate(Session& session, const CLI::App& command, const Generate_options& options)
{
  session.report()["seed"] = options.seed;
  const Kind& kind = find_kind(command, options.kind);
  add_curve_file(session.outputs(), "--output", options.output);
  const Curve curve = make_curve(kind, options);
  session.end_stage("generating");
  write_curve(options.output, curve);
  session.end_stage("writing");
  if(session.has_report()) report_shape(session.report(), curve, 0);
  session.report()["status"] = "done";
  session.print_summary("wrote " + options.output + ": " +
                        counted(curve.number_of_nodes(), "node") + ", " +
                        counted(curve.number_of_components(), "component") + '\n');
  return GOAL_REACHED;
}

} // namespace

void add_generate_command(Command_line& command_line)
{
  const auto options = std::make_shared<Generate_options>();
  const auto self = std::make_shared<CLI::App*>();
  CLI::App& command = command_line.add_command(
      "generate", "make a knot, a link or a random polygon",
      [options, self](Session& session) { return generate(session, **self, *options); });
  *self = &command;
  command.add_option("KIND", options->kind, "torus-knot, braid, random-polygon or hard-unknot")
      ->required()
      ->check(CLI::IsMember(names_of_kinds()).description(""))
      ->type_name("");
  add_curve_output(command, options->output).required();
  add_whole_number(command, "--nodes", options->nodes, "number of nodes in all components together",
                   3, 100000000)
      .capture_default_str();
  add_whole_number(command, "--seed", options->seed,
                   "seed; for a knot, that of its rotation in space, where 0 means none", 0)
      .capture_default_str();
  const int most = 10000;
  command.add_option("--p", options->p, "torus-knot: times around the axis, 1 or more")
      ->check(CLI::Range(1, most).description(""))
      ->capture_default_str()
      ->type_name("N");
  command
      .add_option("--q", options->q,
                  "torus-knot: times around the core; its sign is that of the crossings")
      ->check(CLI::Range(-most, most).description(""))
      ->capture_default_str()
      ->type_name("N");
  command
      .add_option("--word", options->word,
                  "braid: the word of the closed braid; i exchanges the strands i and i + 1, -i "
                  "with a negative crossing")
      ->type_name("\"1 -2 1\"");
  add_whole_number(command, "--moves", options->moves,
                   "hard-unknot: certified random moves that tangle a circle", 0, 100000000)
      .capture_default_str();
  command.footer(
      "torus-knot is a link if p and q have a common divisor. random-polygon has edges of\n"
      "length 1. hard-unknot stays in the unit ball.");
}

} // namespace vfc
