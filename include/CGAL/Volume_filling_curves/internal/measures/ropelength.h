// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_ROPELENGTH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_ROPELENGTH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/measures/Doubly_critical_distance.h>
#include <CGAL/Volume_filling_curves/internal/measures/average_crossing_number.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The radius of the thickest tube around a curve without junctions, see polygonal_thickness().
template <typename Network>
double tube_radius(const Network& curve, Run_watch* watch = nullptr)
{
  return Doubly_critical_distance<Network>(curve)(2 * least_bend_radius(curve), watch) / 2;
}

// Whether the first closed curves have a lower ropelength than the second ones, and about as few
// crossings: tight curves have up to 5 % more of them than the same ones a bit loose. Near linear.
// \throws Run_stopped
template <typename Network>
bool is_tighter(const Network& first, const Network& second, Run_watch& watch)
{
  constexpr double most_crossings = 1.1; // of one, in units of the other's
  const auto ropelength_of = [&](const Network& curve) {
    watch.check();
    return total_length(curve) / tube_radius(curve, &watch);
  };
  return ropelength_of(first) < ropelength_of(second) &&
         average_crossing_number(first, 1, &watch) <=
             most_crossings * average_crossing_number(second, 1, &watch);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_ROPELENGTH_H
