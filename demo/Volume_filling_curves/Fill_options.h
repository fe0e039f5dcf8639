// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FILL_OPTIONS_H
#define VFC_FILL_OPTIONS_H

#include "shared_options.h"

#include <CGAL/Volume_filling_curves/internal/Stop_rules.h>
#include <CGAL/Volume_filling_curves/internal/filling_task.h>

#include <cstddef>
#include <string>

namespace CLI {
class App;
}

namespace vfc {

// The options of vfc fill; defaults are those of the package.
struct Fill_options
{
  std::string mesh, output;
  std::string start; // a curve file, or empty for a circle at the widest place
  double length = 0; // instead of a thickness
  std::string thickness_field, wall = "cover";
  std::size_t seed = 0;
  Film_options film;
  Curve_options curve;
  Flow_options flow = {CGAL::Volume_filling_curves::internal::filling_defaults()};
  CGAL::Volume_filling_curves::internal::Stop_rules stop;

  bool keeps_clear_of_wall() const { return wall == "keep-clear"; }
};

void add_fill_options(CLI::App& command, Fill_options& options);

} // namespace vfc

#endif // VFC_FILL_OPTIONS_H
