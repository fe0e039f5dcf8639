// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/Report.h"

#include "session/errors.h"

#include <algorithm>

namespace vfc {
namespace {

constexpr const char* keys[] = {"command",
                                "input",
                                "version",
                                "commit",
                                "seed",
                                "threads",
                                "status",
                                "exit_status",
                                "proof",
                                "link",
                                "name",
                                "is_proved",
                                "chirality",
                                "knotted",
                                "knottedness",
                                "crossings",
                                "writhe",
                                "determinant",
                                "signature",
                                "alexander_polynomial",
                                "homfly_polynomial",
                                "jones_polynomial",
                                "codes",
                                "chains",
                                "curves",
                                "iterations",
                                "seconds",
                                "cpu_seconds",
                                "seconds_by_stage",
                                "peak_memory_bytes",
                                "nodes_start",
                                "nodes_end",
                                "components",
                                "length_start",
                                "length_end",
                                "thickness",
                                "gradient_norm",
                                "moves_certified",
                                "moves_rejected",
                                "shortened_steps",
                                "refused_remeshing",
                                "sweeps",
                                "tightenings",
                                "is_round",
                                "is_ropelength_lowered",
                                "is_input",
                                "is_closure_kept",
                                "removed_nodes",
                                "min_clearance",
                                "min_strand_distance",
                                "min_strand_points",
                                "min_wall_distance",
                                "min_wall_point",
                                "crowded_fraction",
                                "component_lengths",
                                "total_curvature",
                                "component_total_curvatures",
                                "max_curvature",
                                "min_bend_radius",
                                "min_bend_point",
                                "polygonal_thickness",
                                "ropelength",
                                "average_crossing_number",
                                "linking_matrix",
                                "medial_radius",
                                "coverage",
                                "unfilled_fraction",
                                "uncovered_fraction",
                                "empty_regions",
                                "alignment",
                                "ports",
                                "parts",
                                "unreachable_parts",
                                "thin_fraction",
                                "fitting_thickness",
                                "reason",
                                "outside_nodes",
                                "outside_segments",
                                "defects",
                                "faces",
                                "radius",
                                "arcs",
                                "segments",
                                "distance",
                                "mending",
                                "error"};

template <typename Value>
Report::Json value_or_null(const Value& value, bool applies)
{
  return applies ? Report::Json(value) : Report::Json();
}

} // namespace

std::string report_name(std::string name)
{
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

Report::Report()
{
  for(const char* key : keys) m_json[key] = nullptr;
}

void Report::set_error(const std::string& message)
{
  m_json["status"] = "error";
  m_json["error"] = {
      {"message", message}, {"file", nullptr}, {"line", nullptr}, {"nodes", nullptr}};
}

void Report::set_error(const Input_error& error)
{
  const Defect& defect = error.first_error();
  m_json["status"] = "error";
  m_json["error"] = {{"message", defect.kind + ": " + defect.message},
                     {"file", defect.file},
                     {"line", value_or_null(defect.line, defect.line > 0)},
                     {"nodes", value_or_null(defect.nodes, !defect.nodes.empty())}};
}

// Names of files need not be UTF-8, but JSON is.
std::string Report::to_string() const
{
  return m_json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string Report::to_line() const
{
  return m_json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace vfc
