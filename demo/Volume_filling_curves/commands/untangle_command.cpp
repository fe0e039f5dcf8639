// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc untangle: brings a knot or link to its simplest shape by certified motion.

#include "commands/commands.h"
#include "files/certificates.h"
#include "files/checkpoints.h"
#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "options/Command_line.h"
#include "options/Untangle_options.h"
#include "options/numbers.h"
#include "options/pins.h"
#include "options/thickness.h"
#include "reports/containment.h"
#include "reports/shape.h"
#include "reports/untangle_report.h"
#include "session/Flow_observer.h"
#include "session/Patience.h"
#include "session/interruption.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Shape_finish.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
using curves::Untangling_result;
using curves::Untangling_strategy;

void plan_outputs(Session& session, const Untangle_options& options)
{
  Output_files& outputs = session.outputs();
  add_curve_file(outputs, "--output", options.output);
  outputs.add("--certificate", options.certificate);
  outputs.add("--map", options.film.map);
  plan_checkpoints(session, options.saving);
  outputs.add_folder("--frames", options.film.frames, Frames::is_frame);
}

void pin(Curve& curve, const Untangle_options& options)
{
  pin_nodes(curve, options.curve);
  if(!options.parameters.keep_length) return;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.is_pinned(v))
      throw Usage_error("--keep-length: node " + std::to_string(curve.origin(v) + 1) +
                        " is pinned, so the result cannot be scaled");
}

// Checks whether the requested thickness makes sense. The default is measured later, and may grow
// on the way; only a small spacing can ask for too many nodes then, if there is time to find out.
void check_flow_thickness(const Curve& curve,
                          const curves::Untangling_parameters& parameters,
                          const Patience& patience)
{
  constexpr double harmless_spacing = 0.01;
  const double spacing = parameters.spacing;
  check_thickness(parameters.thickness, curve);
  const double asked = parameters.thickness,
               least = curves::internal::min_thickness_for(parameters);
  if(asked > 0)
    check_number_of_nodes((std::max)(asked, least), options_of_thickness(parameters), spacing,
                          curve);
  if(asked > 0 || spacing >= harmless_spacing) return;
  try {
    const double found = curves::default_thickness<CGAL::Parallel_if_available_tag>(
        curve, parameters.number_of_directions, curves::parameters::progress(patience));
    check_number_of_nodes((std::max)(found, least), "", spacing, curve);
  } catch(const curves::Run_interrupted&) {
    return;
  }
}

// The domain that the curve must stay in, if there is one. \throws Input_error unless it is inside
std::optional<Domain> read_domain(Session& session,
                                  const Untangle_options& options,
                                  const Curve& curve)
{
  if(options.domain.empty()) return std::nullopt;
  std::optional<Domain> domain(std::in_place, read_mesh(session, options.domain).mesh, examined);
  Defects outside = to_defects(curves::containment(curve, *domain), curve, options.file);
  if(!outside.empty())
    throw Input_error(std::move(outside), "strictly inside of " + options.domain);
  return domain;
}

Untangling_result untangle(const Session& session,
                           Curve& curve,
                           const std::optional<Domain>& domain,
                           const Untangle_options& options,
                           const curves::Run_state& state,
                           curves::Isotopy_certificate& certificate,
                           const Patience& patience,
                           Flow_observer& observer)
{
  curves::Untangling_parameters parameters = options.parameters;
  check_flow_thickness(curve, parameters, patience);
  parameters.time_limit = patience.seconds_left();
  parameters.progress = is_to_go_on;
  if(!options.certificate.empty()) parameters.certificate = &certificate;
  parameters.resume_from = &state;
  save_states(session, parameters, options.saving);
  using Tag = CGAL::Parallel_if_available_tag;
  return resume(options.saving, [&] {
    return domain ? curves::untangle<Tag>(curve, *domain, parameters, std::ref(observer))
                  : curves::untangle<Tag>(curve, parameters, std::ref(observer));
  });
}

void write_files(Session& session,
                 const Untangle_options& options,
                 const Curve& curve,
                 double found_thickness,
                 const curves::Isotopy_certificate& certificate)
{
  // the certificate first: no curve comes out of a run that was to be certified without one
  if(!options.certificate.empty()) write_certificate(options.certificate, certificate);
  if(!options.output.empty()) write_curve(options.output, curve, found_thickness);
  write_map(options.film.map, options.output, curve);
  session.end_stage("writing");
}

// Returns whether the curve has its former length, if it is to. Strands in the way of the scaling,
// and coarse coordinates, end it early.
bool is_length_kept(const Session& session,
                    const Untangle_options& options,
                    const Curve& curve,
                    double wanted)
{
  constexpr double precision = 1e-9;
  const double length = curves::length(curve);
  if(!options.parameters.keep_length || std::abs(length - wanted) <= precision * wanted)
    return true;
  session.console().warn("--keep-length: the length is " + to_text(length) + " instead of " +
                         to_text(wanted));
  return false;
}

int run(Session& session, const Untangle_options& options)
{
  session.report()["input"] = options.file;
  session.report()["seed"] = options.parameters.random_seed;
  session.add_input(options.file, "--output");
  const bool is_search = options.parameters.strategy == Untangling_strategy::SEARCH;
  if(!options.domain.empty()) {
    session.add_input(options.domain);
    if(is_search)
      throw Usage_error(
          "--domain: needs --strategy flow or auto, since the search ignores domains");
  }
  if(is_search && curves::internal::shape_goal(options.parameters).is_given())
    throw Usage_error("--bend-radius, --strand-distance: need --strategy flow or auto, since the "
                      "polygons of the search are not round");
  plan_outputs(session, options);
  session.require_output();
  const curves::Run_state state = read_run_state(options.saving);
  Curve curve = read_curve(session, options.file, options.curve.reading);
  const double length = curves::length(curve);
  pin(curve, options);
  const std::optional<Domain> domain = read_domain(session, options, curve);
  curves::Isotopy_certificate certificate;
  Untangling_result result;
  poll_interruptions();
  const Patience patience(options.parameters.time_limit);
  {
    Flow_observer observer(session, options.parameters, options.parameters.tolerance,
                           Frames(options.film, session.console()));
    result = untangle(session, curve, domain, options, state, certificate, patience, observer);
    observer.finish(result.statistics.iterations, curve);
  }
  const bool is_kept = is_length_kept(session, options, curve, length);
  report_stages(session, result.statistics);
  write_files(session, options, curve, result.thickness, certificate);
  if(session.has_report())
    report_shape(session.report(), curve, result.thickness, Patience(patience.seconds_left()));
  session.end_stage("measuring");
  report_run(session.report(), curve, result, options.parameters.strategy);
  const Exit_status status = exit_status(result.status);
  const bool misses_length = status == GOAL_REACHED && !is_kept;
  if(misses_length) session.report()["status"] = "length_not_reached";
  session.print_summary((misses_length ? "length not reached, " : "") +
                        summary(session, curve, result));
  return misses_length ? LIMIT_REACHED : status;
}

} // namespace

void add_untangle_command(Command_line& command_line)
{
  const auto options = std::make_shared<Untangle_options>();
  CLI::App& command = command_line.add_command(
      "untangle", "bring a knot or link to a short and simple shape by certified motion",
      [options](Session& session) { return run(session, *options); });
  add_untangle_options(command, *options);
  add_batch_options(command, *command.get_option("CURVE"),
                    {&options->file,
                     &options->output,
                     {&options->certificate, &options->film.map, &options->film.frames}},
                    command_line);
  command.footer(
      "The curve moves until it is proved unknotted, is tight, or stops making progress; it never\n"
      "passes through itself. Curves with pinned ends use the strategy flow. SIGINT and SIGTERM\n"
      "stop the run and write the current curve; a second signal ends the program.\n"
      "Exit status: 0 unknotted or converged, 2 limit, length or constraint not reached,\n"
      "3 stalled, 5 interrupted.");
}

} // namespace vfc
