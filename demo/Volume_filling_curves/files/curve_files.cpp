// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/curve_files.h"

#include "files/Output_files.h"
#include "files/mesh_files.h"
#include "files/polygon_files.h"
#include "formats/curve_formats.h"
#include "session/Session.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/draft_to_network.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

// Expected contents of a file without a valid curve, and the remedy.
static std::string expected_curve(const std::string& file, const Defects& defects)
{
  const auto has = [&](curves::Curve_defect_kind kind) {
    return std::any_of(defects.begin(), defects.end(),
                       [&](const Defect& defect) { return defect.kind == to_string(kind); });
  };
  const bool is_curve_format = curve_format_of(file) != nullptr;
  if(has(curves::Curve_defect_kind::FACES_ONLY) || (!is_curve_format && is_mesh_file(file)))
    return "a valid curve; it holds a surface";
  if(is_polygon_file(file)) return "a valid curve; it holds polygons, which vfc fill fills";
  return has(curves::Curve_defect_kind::JUNCTION) ? "a valid curve; --network accepts junctions"
                                                  : "a valid curve";
}

static curves::Junctions junctions_of(const Curve_reading& reading)
{
  return reading.is_network ? curves::Junctions::ALLOWED : curves::Junctions::FORBIDDEN;
}

static std::optional<curves::Closure> closure_of(const Curve_reading& reading)
{
  if(reading.is_closed) return curves::Closure::CLOSED;
  if(reading.is_open) return curves::Closure::OPEN;
  return std::nullopt;
}

curves::internal::Curve_draft read_curve_draft(const std::string& file,
                                               const Curve_reading& reading)
{
  return curves::internal::read_curve_draft(curve_formats(), file, junctions_of(reading),
                                            closure_of(reading));
}

Curve_and_defects read_curve_and_defects(const std::string& file, const Curve_reading& reading)
{
  Curve_and_defects result;
  std::vector<curves::Curve_defect> defects;
  curves::internal::Curve_draft draft = read_curve_draft(file, reading);
  result.is_valid = curves::internal::draft_to_embedded_network(draft, result.curve, defects,
                                                                junctions_of(reading));
  for(curves::Curve_defect& defect : defects)
    if(defect.kind == curves::Curve_defect_kind::UNDECIDED_CLOSURE)
      defect.message += ": give --closed or --open";
  result.defects = make_defects(defects, file);
  return result;
}

Curve read_curve(Session& session, const std::string& file, const Curve_reading& reading)
{
  Report& report = session.report();
  report["input"] = file;
  Curve_and_defects read = read_curve_and_defects(file, reading);
  if(!read.is_valid) {
    const std::string expected = expected_curve(file, read.defects);
    throw Input_error(std::move(read.defects), expected);
  }
  print_defects(session.console(), read.defects);
  report["components"] = read.curve.number_of_components();
  report["nodes_start"] = read.curve.number_of_nodes();
  report["length_start"] = curves::length(read.curve);
  session.end_stage("reading");
  return std::move(read.curve);
}

void add_curve_file(Output_files& outputs, const std::string& option, const std::string& file)
{
  const Curve_format* const format = curve_format_of(file);
  const auto is_written = [](const Curve_format& known) { return known.is_written(); };
  if(!file.empty() && (format == nullptr || !format->is_written()))
    throw Usage_error(option + ": " + file + ": curves are written to " +
                      curves::internal::extensions_text(curve_formats(), is_written) + " files");
  outputs.add(option, file);
}

void write_curve(const std::string& file, const Curve& curve, double thickness)
{
  constexpr double cap = 2; // in units of the thickness: many spheres touch nothing at all
  const Curve_format* const format = curve_format_of(file);
  const curves::internal::Curve_paths paths(curve);
  if(format->write != nullptr) return Output_files::write(file, format->write(paths));
  Node_columns columns = node_columns(curve);
  if(thickness > 0)
    columns.push_back(
        {"radius", curves::medial_radii<CGAL::Parallel_if_available_tag>(curve, cap * thickness)});
  Output_files::write(file, format->write_with_columns(paths, columns));
}

// Returns the nodes in the order in which they stand in a file of this name. Where polylines are
// listed one by one, those that meet in junctions leave the network's order.
static std::vector<std::size_t> nodes_in_file_order(const std::string& file, const Curve& curve)
{
  std::vector<std::size_t> nodes(curve.number_of_nodes());
  std::iota(nodes.begin(), nodes.end(), std::size_t(0));
  const Curve_format* const format = curve_format_of(file);
  if(format == nullptr || format->has_numbered_nodes) return nodes;
  nodes.clear();
  std::vector<bool> is_listed(curve.number_of_nodes(), false);
  for(const auto& path : curves::internal::Curve_paths(curve).paths)
    for(const std::size_t v : path) {
      if(!is_listed[v]) nodes.push_back(v);
      is_listed[v] = true;
    }
  return nodes;
}

void write_map(const std::string& map, const std::string& output, const Curve& curve)
{
  if(map.empty()) return;
  std::string text;
  for(const std::size_t v : nodes_in_file_order(output, curve)) {
    const std::size_t origin = curve.origin(v);
    text += std::to_string(origin == Curve::null_node() ? 0 : origin + 1) + '\n';
  }
  Output_files::write(map, text);
}

} // namespace vfc
