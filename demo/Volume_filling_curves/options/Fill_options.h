// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FILL_OPTIONS_H
#define VFC_FILL_OPTIONS_H

#include "options/shared_options.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vfc {

// The options of vfc fill; defaults are those of the package.
struct Fill_options
{
  std::string mesh, output, certificate;
  std::vector<std::string> obstacles;
  std::string start; // a curve file, or empty for a circle at the widest place
  std::vector<std::string> ports;
  std::string symmetry;
  std::string thickness_field; // a file
  std::string direction_field; // a file, or a vector
  bool may_repair = false;     // the mesh
  Film_options film;
  Checkpoint_options saving;
  Curve_options curve;
  CGAL::Volume_filling_curves::Filling_parameters<> parameters;
};

void add_fill_options(CLI::App& command, Fill_options& options);

} // namespace vfc

#endif // VFC_FILL_OPTIONS_H
