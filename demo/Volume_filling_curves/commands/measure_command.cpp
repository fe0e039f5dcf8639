// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc measure: measures of a curve.

#include "commands/commands.h"
#include "files/curve_files.h"
#include "files/polygon_files.h"
#include "options/Command_line.h"
#include "options/numbers.h"
#include "options/option_kinds.h"
#include "options/shared_options.h"
#include "reports/containment.h"
#include "reports/coverage_report.h"
#include "reports/report_rows.h"
#include "reports/shape.h"
#include "session/Exit_status.h"

#include <CGAL/Volume_filling_curves/coverage.h>

#include <CGAL/tags.h>

#include <memory>
#include <string>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

struct Measure_options
{
  std::string file, mesh;
  double thickness = 0;
  std::size_t seed = 0;
  Curve_reading reading;
};

// One line per key of the report.
std::string table(const Report& report)
{
  std::string text;
  for(const std::string key :
      {"components", "nodes_end", "length_end", "component_lengths", "thickness", "min_clearance",
       "min_strand_distance", "min_strand_points", "crowded_fraction", "total_curvature",
       "component_total_curvatures", "max_curvature", "min_bend_radius", "min_bend_point",
       "polygonal_thickness", "ropelength", "average_crossing_number", "linking_matrix",
       "medial_radius"})
    text += row(key, report[key]);
  return text;
}

// Measures inside the mesh.
std::string table_of_filling(const Report& report)
{
  std::string text;
  for(const std::string key :
      {"outside_nodes", "outside_segments", "min_wall_distance", "min_wall_point"})
    text += row(key, report[key]);
  for(const auto& [key, value] : report["coverage"].items()) text += row("coverage_" + key, value);
  text += row("unfilled_fraction", report["unfilled_fraction"]);
  for(const Report::Json& region : report["empty_regions"])
    text += row("empty_region", Report::Json::array({region["point"], region["volume"]}));
  return text;
}

// The distance is 0 if the curve meets the surface or leaves the mesh.
template <typename Domain>
void measure_wall_distance(Report& report, const Curve& curve, const Domain& domain)
{
  const Containment found = containment(curve, domain);
  report_containment(report, found);
  report["min_wall_distance"] = 0;
  if(!found.is_inside()) return;
  const auto nearest = curves::min_wall_distance<CGAL::Parallel_if_available_tag>(curve, domain);
  report_wall(report, nearest.distance, nearest.point);
}

void measure_filling(Session& session, const Measure_options& options, const Curve& curve)
{
  const Thickness thickness =
      options.thickness > 0 ? constant_thickness(options.thickness) : Thickness();
  with_domain(session, options.mesh, [&](const auto& domain) {
    measure_wall_distance(session.report(), curve, domain);
    measure_coverage(session.report(), curve, domain, thickness, options.seed);
  });
  session.report()["seed"] = options.seed;
}

int measure(Session& session, const Measure_options& options)
{
  session.report()["input"] = options.file;
  session.add_input(options.file);
  if(!options.mesh.empty()) session.add_input(options.mesh);
  const Curve curve = read_curve(session, options.file, options.reading);
  report_shape(session.report(), curve, options.thickness);
  if(!options.mesh.empty()) measure_filling(session, options, curve);
  session.end_stage("measuring");
  session.report()["status"] = "done";
  session.print_result(table(session.report()));
  if(!options.mesh.empty()) session.print_result(table_of_filling(session.report()));
  return GOAL_REACHED;
}

} // namespace

void add_measure_command(Command_line& command_line)
{
  const auto options = std::make_shared<Measure_options>();
  CLI::App& command =
      command_line.add_command("measure", "measure a curve, and how it fills a mesh",
                               [options](Session& session) { return measure(session, *options); });
  add_curve(command, options->file);
  add_mesh(command, options->mesh)
      .description("a surface, or polygons (.wkt), that the curve should fill");
  add_number(command, "--thickness", options->thickness,
             "r, in the input's unit: segments within pi r of each other along the curve do not "
             "count for min_clearance; needed for medial_radius and empty_regions")
      .type_name("R");
  add_seed_option(command, options->seed, "seed of the samples in MESH");
  add_reading_flags(command, options->reading);
  command.footer(
      "Prints the keys of the report, with - if a key does not apply. Lengths are in the input's "
      "unit,\n"
      "curvatures in its reciprocal, angles in radians.\n"
      "  total_curvature      sum of the turning angles; 2 pi for a circle\n"
      "  min_bend_radius      least bend radius of a corner, at min_bend_point; 1 / max_curvature\n"
      "  polygonal_thickness  radius of the thickest tube around the curve\n"
      "  ropelength           length / polygonal_thickness; 2 pi for a circle\n"
      "  min_clearance        least distance of two segments that are not neighbors\n"
      "  min_strand_distance  the same, between min_strand_points; only with --thickness\n"
      "  crowded_fraction     share of the length along which another strand is nearer than r\n"
      "  medial_radius        mean of the medial radii, capped at 2 r\n"
      "With MESH:\n"
      "  outside_segments     segments with a point on or beyond the surface, counted exactly\n"
      "  min_wall_distance    least distance of the curve to the surface, at min_wall_point\n"
      "  coverage             distances of samples of the inside to the curve, in units of r\n"
      "  empty_region         center and volume of a region farther than 2 r from the curve");
}

} // namespace vfc
