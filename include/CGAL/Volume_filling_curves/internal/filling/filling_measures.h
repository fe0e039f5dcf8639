// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_MEASURES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_MEASURES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/domain/Least_depth.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/measures/Crowding.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Measures where a curve comes closest to itself and to the boundary of its domain.
template <typename ConcurrencyTag,
          typename Result,
          typename Network,
          typename Domain,
          typename Thickness>
void measure_shape(Result& result,
                   const Network& curve,
                   const Domain& domain,
                   const Thickness& thickness)
{
  const auto point = [&](const Vector& p) { return to_point(p, curve.traits()); };
  const Corner tightest = tightest_corner(curve);
  result.min_bend_radius = tightest.bend_radius;
  result.tightest_node = tightest.node;
  const Crowding crowding(curve, thickness);
  result.crowded_fraction = crowding.template fraction<ConcurrencyTag>();
  const auto strands = crowding.closest();
  result.min_strand_distance = strands.distance;
  result.closest_points = {point(strands.points[0]), point(strands.points[1])};
  const auto nearest = Least_depth<ConcurrencyTag, Network, Domain>(curve, domain)();
  result.min_wall_distance = nearest.distance;
  result.point_nearest_to_wall = point(nearest.point);
}

// Measures the coverage of a curve and its shape, as far as time allows; then calls a function that
// measures more, and searches for empty regions. A run that is to stop has a tenth of a second for
// that, enough for 50,000 nodes. A share that is not measured is NaN.
template <typename Result,
          typename Unfilled,
          typename Network,
          typename Thickness,
          typename Function>
void measure_filling(Result& result,
                     const Unfilled& unfilled,
                     const Network& curve,
                     const Thickness& thickness,
                     Run_watch& watch,
                     const Function& measure_more)
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
    measure_shape<typename Unfilled::Concurrency_tag>(result, curve, unfilled.samples().domain(),
                                                      thickness);
    measure_more();
    result.empty_regions = unfilled.regions(curve, distances, thickness);
    result.are_empty_regions_known = true;
  } catch(const Run_stopped&) {
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_MEASURES_H
