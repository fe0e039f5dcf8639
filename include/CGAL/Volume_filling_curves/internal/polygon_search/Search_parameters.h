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
// rates are probabilities per move; all other moves shake a node. benchmark_search on the unknots
// of Haken, Ochiai, and Petronio and Zanellati gave these values (2026-11-21): a factor of two in
// the rates makes little difference. In earlier trials with other rates and 6 seeds, one search for
// Ochiai's fourth unknot got stuck without clearance; with 0.01 Haken's took four times as long.
struct Search_parameters
{
  double temperature = 0.8; // typical length that a move may add
  double clearance = 1e-3;  // between edges without a common node
  double max_step = 1;
  std::size_t number_of_step_sizes = 5; // each half of the one before
  double removal_rate = 0.05;
  double insertion_rate = 0.01;
  double smoothing_rate = 0.2;

  // The number of attempts without progress after which a search ends. A long attempt is not
  // repeated: `max_moves_in_vain()` ends the search earlier.
  int max_attempts_in_vain = 3;
  double patience_factor = 1;

  // The number of changes, 12 MB, after which an attempt ends. Petronio and Zanellati's PZ120 takes
  // up to 280,000 (5 seeds, 2026-11-22), all other unknots take less.
  std::size_t max_operations = 300'000;

  // Progress is a reduction of the edges to this share; up to 20 edges, by a single edge.
  static constexpr double progress = 0.95;

  // The number of moves without progress after which an attempt ends, for a curve of n edges. Knots
  // of 10 crossings reach 12 edges within 100,000 moves. Unknots that are stuck come loose within
  // 40,000 moves at 15 to 20 edges, Haken's within 320,000 at 59, and PZ120 within 660,000 at 65
  // and 810,000 at 72 (5 seeds, 2026-11-22). Beyond that the flow takes over; if the flow jams, a
  // search with more patience follows.
  std::size_t patience(std::size_t n) const
  {
    const double square = static_cast<double>(n) * static_cast<double>(n), power = square * square;
    const double moves = (std::max)((std::min)(power / 2, 1e5), power / 25);
    return static_cast<std::size_t>(patience_factor * std::clamp(moves, 1e4, 1e6));
  }

  // The number of moves since the best polygon after which no further attempt starts.
  std::size_t max_moves_in_vain() const
  {
    return static_cast<std::size_t>(patience_factor * 1.5e5);
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_PARAMETERS_H
