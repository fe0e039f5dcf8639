// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_MEASURE_FILLING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_MEASURE_FILLING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Measures where a curve has got to, as far as there is time. A run that is to stop has a tenth of
// a second for that, enough for 50,000 nodes. A share that is not measured is not a number.
template <typename Result, typename Unfilled, typename Network, typename Thickness>
void measure_filling(Result& result,
                     const Unfilled& unfilled,
                     const Network& curve,
                     const Thickness& thickness,
                     Run_watch& watch)
{
  constexpr double seconds_to_measure = 0.1;
  watch.begin(Run_stage::MEASURING);
  watch.grant(seconds_to_measure);
  const Watched_scope scope(&watch);
  result.unfilled_fraction = result.uncovered_fraction = std::numeric_limits<double>::quiet_NaN();
  try {
    const std::vector<double> distances = unfilled.distances(curve);
    result.coverage = coverage(unfilled.samples(), distances, thickness);
    result.unfilled_fraction = unfilled.fraction(distances, thickness);
    result.uncovered_fraction = unfilled_fraction(unfilled.samples(), distances, thickness);
    result.empty_regions = unfilled.regions(curve, distances, thickness);
    result.are_empty_regions_known = true;
  } catch(const Run_stopped&) {
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_MEASURE_FILLING_H
