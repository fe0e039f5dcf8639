// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "options/numbers.h"
#include "repair/shells_apart.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vfc {
namespace {

constexpr double max_area = 0.01; // of sheets; the area of all faces is 1

double area(const std::vector<Mesh>& parts)
{
  double sum = 0;
  for(const Mesh& part : parts) sum += CGAL::Polygon_mesh_processing::area(part);
  return sum;
}

} // namespace

std::string drop_sheets(Mesh& mesh, Work_watch& watch)
{
  watch.check();
  std::vector<Mesh> parts = shells_apart(mesh);
  const auto end = std::stable_partition(parts.begin(), parts.end(),
                                         [](const Mesh& part) { return CGAL::is_closed(part); });
  const std::vector<Mesh> sheets(end, parts.end());
  if(sheets.empty() || area(sheets) > max_area * area(parts)) return "";
  parts.erase(end, parts.end());
  mesh = shells_together(parts);
  return counted(sheets.size(), "sheet that encloses", "sheets that enclose") + " nothing dropped";
}

} // namespace vfc
