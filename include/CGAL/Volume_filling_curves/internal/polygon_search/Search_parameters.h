// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Parameters of a Search_chain and its walk. Lengths are in units of the mean edge length, and
// rates are probabilities per move; all other moves shake a node. Found with benchmark_search on
// the unknots of Haken, Ochiai, and Petronio and Zanellati, 2026-11-21: rates may vary by a factor
// of two. In earlier trials with other rates and 6 seeds, one search for Ochiai's fourth unknot got
// stuck without a clearance, and with 0.01 Haken's took four times as long.
struct Search_parameters
{
  double temperature = 0.8; // how much longer a curve may get at a time
  double clearance = 1e-3;  // of edges without a common node
  double max_step = 1;
  std::size_t number_of_step_sizes = 5; // each half of the one before
  double removal_rate = 0.05;
  double insertion_rate = 0.01;
  double smoothing_rate = 0.2;

  // The number of attempts without progress after which a search ends, if it has not yet made too
  // many moves without progress: a long attempt is not repeated.
  int max_attempts_in_vain = 3;
  double patience_factor = 1;

  // The number of changes that an attempt remembers, and ends with: 12 MB. Petronio and Zanellati's
  // PZ120 takes up to 280,000 (5 seeds, 2026-11-22), all other unknots take less.
  std::size_t max_operations = 300'000;

  // Progress is a fall to this share of the edges; up to 20 edges, a single one.
  static constexpr double progress = 0.95;

  // The number of moves without progress after which an attempt ends, for a curve of n edges. Knots
  // of 10 crossings reach 12 edges within 100,000 moves; unknots that are stuck at 15 to 20 edges
  // come loose within 40,000 moves, Haken's at 59 within 320,000, and PZ120 at 65 within 660,000
  // and at 72 within 810,000 (5 seeds, 2026-11-22). A knot that needs more is one for the flow; a
  // flow that jams is followed by a search with more patience.
  std::size_t patience(std::size_t n) const
  {
    const double square = static_cast<double>(n) * static_cast<double>(n), power = square * square;
    const double moves = (std::max)((std::min)(power / 2, 1e5), power / 25);
    return static_cast<std::size_t>(patience_factor * std::clamp(moves, 1e4, 1e6));
  }

  // The number of moves since the fewest edges were reached after which no further attempt starts.
  std::size_t max_moves_in_vain() const
  {
    return static_cast<std::size_t>(patience_factor * 1.5e5);
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_PARAMETERS_H
