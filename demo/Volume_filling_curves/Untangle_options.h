// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_UNTANGLE_OPTIONS_H
#define VFC_UNTANGLE_OPTIONS_H

#include "shared_options.h"

#include <CGAL/Volume_filling_curves/Untangling_strategy.h>
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
  std::string file, output, certificate, name_of_strategy = "auto";
  std::size_t seed = 0, number_of_chains = 2;
  bool keeps_length = false, finishes = false;
  Film_options film;
  Curve_options curve;
  Flow_options flow;
  CGAL::Volume_filling_curves::internal::Stop_rules stop; // but for the proof

  CGAL::Volume_filling_curves::Untangling_strategy strategy() const;
};

void add_untangle_options(CLI::App& command, Untangle_options& options);

} // namespace vfc

#endif // VFC_UNTANGLE_OPTIONS_H
