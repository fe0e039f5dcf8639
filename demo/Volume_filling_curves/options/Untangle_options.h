// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_UNTANGLE_OPTIONS_H
#define VFC_UNTANGLE_OPTIONS_H

#include "options/shared_options.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>

#include <string>

namespace CLI {
class App;
}

namespace vfc {

// The options of vfc untangle; defaults are those of the package.
struct Untangle_options
{
  std::string file, output, certificate;
  std::string domain; // a mesh that the curve must not leave, or empty
  Film_options film;
  Checkpoint_options saving;
  Curve_options curve;
  CGAL::Volume_filling_curves::Untangling_parameters parameters;
};

void add_untangle_options(CLI::App& command, Untangle_options& options);

} // namespace vfc

#endif // VFC_UNTANGLE_OPTIONS_H
