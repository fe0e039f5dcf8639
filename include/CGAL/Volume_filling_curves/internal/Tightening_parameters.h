// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// How a Tightening_search goes about it. Lengths are in units of the mean length of an edge, and
// rates are probabilities per move; the moves that are left over shake a node.
// Found with benchmark_tighten on Haken's, Ochiai's and Petronio and Zanellati's unknots, 2026-11-21:
// rates may vary by a factor of two. In first trials, with other rates and 6 seeds, one search for
// Ochiai's fourth unknot got stuck without a clearance, and with 0.01 Haken's took four times as long.
struct Tightening_parameters
{
  double temperature = 0.8; // how much longer a curve may get at a time
  double clearance = 1e-3;  // of edges without a common node
  double largest_step = 1;
  std::size_t number_of_step_sizes = 5; // each half of the one before
  double removal_rate = 0.05;
  double insertion_rate = 0.01;
  double smoothing_rate = 0.2;

  // How often a search starts again without getting any further.
  int max_attempts_in_vain = 3;
  double patience_factor = 1;

  // The number of moves without progress after which an attempt ends, for a curve of n edges. Knots
  // of 10 crossings get to 12 edges within 100,000 moves; unknots that are stuck at 15 to 20 edges
  // come loose within 40,000 moves, and at 50 edges within a million (8 to 10 seeds).
  std::size_t patience(std::size_t n) const
  {
    const double edges = static_cast<double>(n);
    return static_cast<std::size_t>(patience_factor *
                                    (std::max)(1e4, edges * edges * edges * edges / 2));
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_PARAMETERS_H
