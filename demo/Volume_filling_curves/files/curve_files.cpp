// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/curve_files.h"

#include "files/mesh_files.h"
#include "session/Session.h"

#include <CGAL/Volume_filling_curves/IO/embedded_polylines.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <numeric>
#include <system_error>
#include <utility>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

// What a file that holds no valid curve should hold, and what would help.
static std::string expected_curve(const std::string& file, const Defects& defects)
{
  const auto has = [&](curves::Curve_defect_kind kind) {
    return std::any_of(defects.begin(), defects.end(),
                       [&](const Defect& defect) { return defect.kind == to_string(kind); });
  };
  const bool is_curve_format = curves::internal::Curve_format::of(file) != nullptr;
  if(has(curves::Curve_defect_kind::FACES_ONLY) || (!is_curve_format && is_mesh_file(file)))
    return "a valid curve; it holds a surface";
  return has(curves::Curve_defect_kind::JUNCTION) ? "a valid curve; --network accepts junctions"
                                                  : "a valid curve";
}

Curve_and_defects read_curve_and_defects(const std::string& file, bool is_network)
{
  Curve_and_defects result;
  const auto junctions = is_network ? curves::Junctions::ALLOWED : curves::Junctions::FORBIDDEN;
  std::vector<curves::Curve_defect> defects;
  result.is_valid = CGAL::IO::read_embedded_curve_network(file, result.curve, defects, junctions);
  result.defects = make_defects(defects, file);
  return result;
}

Curve read_curve(Session& session, const std::string& file, bool is_network)
{
  Report& report = session.report();
  report["input"] = file;
  Curve_and_defects read = read_curve_and_defects(file, is_network);
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
  using Format = curves::internal::Curve_format;
  const Format* const format = Format::of(file);
  if(!file.empty() && (format == nullptr || !format->is_written()))
    throw Usage_error(option + ": " + file + ": curves are written to " +
                      Format::written_extensions + " files");
  outputs.add(option, file);
}

void write_curve(const std::string& file, const Curve& curve, double thickness)
{
  constexpr double cap = 2; // in units of the thickness: many spheres touch nothing at all
  curves::Node_values values;
  const auto* const format = curves::internal::Curve_format::of(file);
  if(thickness > 0 && format != nullptr && format->write_with_values != nullptr)
    values["radius"] =
        curves::medial_radii<CGAL::Parallel_if_available_tag>(curve, cap * thickness);
  std::error_code error;
  if(!CGAL::IO::write_curve_network(file, curve, values, error))
    throw Usage_error(file + ": cannot be written: " + error.message());
}

// Where polylines are listed one by one, those that meet in junctions leave the network's order.
std::vector<std::size_t> nodes_in_file_order(const std::string& file, const Curve& curve)
{
  std::vector<std::size_t> nodes(curve.number_of_nodes());
  std::iota(nodes.begin(), nodes.end(), std::size_t(0));
  const auto* const format = curves::internal::Curve_format::of(file);
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

} // namespace vfc
