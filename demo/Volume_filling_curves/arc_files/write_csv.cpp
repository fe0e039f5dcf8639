// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "arc_files/arc_writers.h"
#include "options/numbers.h"

namespace vfc {

std::string to_csv(const Arcs& arcs)
{
  std::string text = "component,path,start_x,start_y,start_z,middle_x,middle_y,middle_z,"
                     "end_x,end_y,end_z,radius\n";
  std::size_t number = 0;
  for(const auto& path : arcs.paths) {
    for(const auto& piece : path.pieces) {
      text += std::to_string(path.component) + ',' + std::to_string(number);
      for(const Curve::Point_3& p : {piece.start, piece.middle, piece.end})
        for(const double x : {p.x(), p.y(), p.z()}) text += ',' + to_exact_text(x);
      text += ',' + (piece.is_arc() ? to_exact_text(piece.radius) : "") + '\n';
    }
    ++number;
  }
  return text;
}

} // namespace vfc
