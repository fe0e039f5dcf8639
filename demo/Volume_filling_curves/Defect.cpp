// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Defect.h"

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

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

Defect::Defect(const curves::Mesh_defect& defect, const std::string& file_name)
    : kind(curves::to_string(defect.kind)),
      is_error(curves::is_error(defect.kind)),
      file(file_name),
      line(defect.line),
      nodes(defect.vertices),
      faces(defect.faces),
      component(defect.shell),
      message(defect.message),
      text(curves::to_string(defect, file_name))
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
      text(file_name + ": error: " + kind_name + ": " + what)
{
  if(nodes.empty()) return;
  text += nodes.size() == 1 ? " (node" : " (nodes";
  for(const std::size_t v : nodes) text += ' ' + std::to_string(v);
  text += ')';
}

} // namespace vfc
