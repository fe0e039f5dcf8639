// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/Defect.h"

#include <algorithm>

namespace vfc {

namespace {

namespace curves = CGAL::Volume_filling_curves;

// returns " (nodes 1 2 3)", with at most ten of the numbers
std::string list(const char* one, const char* many, const std::vector<std::size_t>& numbers)
{
  constexpr std::size_t max_listed = 10;
  if(numbers.empty()) return "";
  std::string text = std::string(" (") + (numbers.size() == 1 ? one : many);
  for(std::size_t i = 0; i < (std::min)(numbers.size(), max_listed); ++i)
    text += ' ' + std::to_string(numbers[i]);
  return text + (numbers.size() > max_listed ? " ...)" : ")");
}

} // namespace

Defect::Defect(const curves::Curve_defect& defect, const std::string& file_name)
    : kind(curves::to_string(defect.kind)),
      is_error(curves::is_error(defect.kind)),
      file(file_name),
      line(defect.line),
      nodes(defect.nodes),
      component(defect.component),
      message(defect.message),
      text(curves::to_string(defect, file_name))
{}

Defect::Defect(const std::string& kind_name,
               bool is_an_error,
               const std::string& file_name,
               const Mesh_location& location,
               const std::string& what)
    : kind(kind_name),
      is_error(is_an_error),
      file(file_name),
      line(location.line),
      nodes(location.vertices),
      faces(location.faces),
      component(location.shell),
      message(what),
      text(file_name + (line > 0 ? ':' + std::to_string(line) : "") +
           (is_error ? ": error: " : ": warning: ") + kind_name + ": " + what +
           list("vertex", "vertices", nodes) + list("face", "faces", faces))
{}

Defect::Defect(const std::string& kind_name,
               const std::string& file_name,
               const std::vector<std::size_t>& node_numbers,
               std::size_t component_number,
               const std::string& what)
    : kind(kind_name),
      is_error(true),
      file(file_name),
      nodes(node_numbers),
      component(component_number),
      message(what),
      text(file_name + ": error: " + kind_name + ": " + what + list("node", "nodes", nodes))
{}

} // namespace vfc
