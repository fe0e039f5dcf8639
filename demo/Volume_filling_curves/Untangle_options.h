// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_UNTANGLE_OPTIONS_H
#define VFC_UNTANGLE_OPTIONS_H

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/Stop_rules.h>

#include <cstddef>
#include <string>

namespace CLI {
class App;
}

namespace vfc {

// The options of vfc untangle; defaults are those of the package.
struct Untangle_options
{
  std::string file, output, map, frames, pin;
  std::string strategy = "flow", name_of_preconditioner = "medial";
  std::size_t every = 1, seed = 0;
  bool is_network = false, has_free_ends = false, keeps_length = false, finishes = false;
  CGAL::Volume_filling_curves::Curve_flow_parameters flow; // but for the preconditioner
  CGAL::Volume_filling_curves::internal::Stop_rules stop;  // but for the proof

  CGAL::Volume_filling_curves::Preconditioner preconditioner() const;
};

void add_untangle_options(CLI::App& command, Untangle_options& options);

} // namespace vfc

#endif // VFC_UNTANGLE_OPTIONS_H
