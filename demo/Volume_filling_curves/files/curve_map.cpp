// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/curve_map.h"

#include "files/Output_files.h"

#include <cstddef>

namespace vfc {

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
