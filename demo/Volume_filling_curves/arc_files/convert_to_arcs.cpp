// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "arc_files/convert_to_arcs.h"

#include "arc_files/arc_writers.h"
#include "files/Output_files.h"
#include "files/polygon_files.h"
#include "meshes/read_mesh_soup.h"
#include "options/numbers.h"
#include "options/option_kinds.h"
#include "reports/containment.h"
#include "session/Exit_status.h"
#include "session/Session.h"

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

bool is_step(const std::string& extension)
{
  return extension == ".step" || extension == ".stp";
}

std::string file_text(const Arcs& arcs, Length_unit unit, const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  try {
    if(extension == ".csv") return to_csv(arcs);
    return is_step(extension) ? to_step(arcs, unit) : to_svg(arcs, unit);
  } catch(const std::invalid_argument& error) {
    throw Usage_error("--output: " + file + ": " + error.what());
  }
}

// Nodes count from 1.
Defect to_defect(const curves::Arc_conflict& conflict, const Curve& curve, const std::string& file)
{
  const auto defect = [&](const std::vector<std::size_t>& nodes, const std::string& message) {
    return Defect("uncertified arc", file, nodes, curve.component(conflict.node) + 1, message);
  };
  const std::size_t node = conflict.node + 1;
  switch(conflict.obstacle) {
  case curves::Arc_obstacle::STRAND:
    return defect({node, conflict.other + 1}, "the corner is cut by another strand");
  case curves::Arc_obstacle::BOUNDARY:
    return defect({node}, "the corner is cut by the boundary of the domain");
  default:
    return defect({node}, "the edges are lost in the rounding of coordinates");
  }
}

Arcs make_arcs(Session& session,
               const Arc_options& options,
               const Curve& curve,
               const std::string& file)
{
  if(options.domain.empty()) return curves::arc_spline(curve);
  return with_domain(session, options.domain, [&](const auto& domain) {
    const Containment found = containment(curve, domain);
    if(!found.is_inside())
      throw Input_error(to_defects(found, curve, file), "inside " + options.domain);
    return curves::arc_spline(curve, domain);
  });
}

void check_certified(Session& session,
                     const Arc_options& options,
                     const Arcs& arcs,
                     const Curve& curve,
                     const std::string& file)
{
  if(arcs.is_certified) return;
  Defects defects;
  for(const curves::Arc_conflict& conflict : arcs.conflicts)
    defects.push_back(to_defect(conflict, curve, file));
  if(!options.is_uncertified_welcome)
    throw Input_error(std::move(defects), "a curve with an arc spline that can be certified; "
                                          "--uncertified writes it nevertheless");
  print_defects(session.console(), defects);
  session.console().warn("--arcs: the arc spline is not certified: it may be another knot, touch "
                         "itself or leave the domain");
}

void report_arcs(Session& session, const Arcs& arcs, const std::string& output)
{
  session.report()["arcs"] = arcs.number_of_arcs;
  session.report()["segments"] = arcs.number_of_segments;
  session.report()["min_bend_radius"] = arcs.min_radius;
  session.report()["distance"] = arcs.max_distance;
  session.report()["length_end"] = arcs.length;
  session.print_summary("wrote " + output + ": " + counted(arcs.number_of_arcs, "arc") + ", " +
                        counted(arcs.number_of_segments, "segment") + ", least radius " +
                        to_text(arcs.min_radius) + ", within " + to_text(arcs.max_distance) +
                        " of CURVE, length " + to_text(arcs.length) +
                        (arcs.is_certified ? ", certified\n" : ", not certified\n"));
}

} // namespace

CLI::Option& add_arc_options(CLI::App& command, Arc_options& options)
{
  CLI::Option& arcs = *command.add_flag(
      "--arcs", options.is_wanted,
      "write the smooth curve of arcs and segments through CURVE, certified to be isotopic: .csv, "
      ".step, or .svg if it is planar");
  add_file(command, "--domain", options.domain,
           "certify that the arcs are inside this mesh, or polygons (.wkt)")
      .type_name("MESH")
      ->needs(&arcs);
  command
      .add_flag("--uncertified", options.is_uncertified_welcome,
                "write arcs that are not certified, and exit with 2")
      ->needs(&arcs);
  add_unit_option(command, options.unit);
  return arcs;
}

void plan_arc_files(Session& session, const Arc_options& options, const std::string& output)
{
  const std::string extension = lower_case_extension(output);
  if(extension != ".csv" && extension != ".svg" && !is_step(extension))
    throw Usage_error("--output: " + output + ": arcs are written to .csv, .step or .svg files");
  if(!options.domain.empty()) session.add_input(options.domain);
  session.outputs().add("--output", output);
}

int convert_to_arcs(Session& session,
                    const Arc_options& options,
                    const Curve& curve,
                    const std::string& file,
                    const std::string& output)
{
  const Arcs arcs = make_arcs(session, options, curve, file);
  check_certified(session, options, arcs, curve, file);
  Output_files::write(output, file_text(arcs, options.unit, output));
  report_arcs(session, arcs, output);
  return arcs.is_certified ? GOAL_REACHED : LIMIT_REACHED;
}

} // namespace vfc
