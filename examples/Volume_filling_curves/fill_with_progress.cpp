// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Prints each stage of a filling, and ends the run when the curve is long enough.

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <cstdlib>
#include <iostream>
#include <optional>

namespace VFC = CGAL::Volume_filling_curves;

int main()
{
  const VFC::Ball_domain_3<> ball({0, 0, 0}, 1);
  VFC::Curve_network_3<> curve;
  const double wanted_length = 20;
  std::optional<VFC::Run_stage> stage;

  //! [progress]
  const auto report = [&](const VFC::Run_progress& progress) {
    if(progress.stage != stage) std::cout << progress.stage << '\n';
    stage = progress.stage;
    return progress.length < wanted_length;
  };
  const auto result = VFC::fill(curve, ball, VFC::parameters::thickness(0.2).progress(report));
  //! [progress]

  std::cout << result.status << " at the length " << VFC::length(curve) << '\n';
  const bool is_as_wanted =
      result.status == VFC::Filling_status::INTERRUPTED && VFC::length(curve) >= wanted_length;
  return is_as_wanted ? EXIT_SUCCESS : EXIT_FAILURE;
}
