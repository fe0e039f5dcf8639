// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_MOTION_OUTCOME_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_MOTION_OUTCOME_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The share of their way that the nodes that were to move have gone; pinned ones were not.
struct Motion_outcome
{
  double mean_fraction = 1; // of their ways
  bool are_nodes_held = false;

  bool has_moved() const { return mean_fraction > 0; }
  bool is_shortened() const { return mean_fraction < 1; }
};

// Takes the part of its way that each node has gone, and the direction of the way.
inline Motion_outcome motion_outcome(const std::vector<double>& fractions,
                                     const Vector_field& direction)
{
  Motion_outcome outcome;
  double sum = 0;
  std::size_t number_of_ways = 0;
  for(std::size_t v = 0; v < fractions.size(); ++v) {
    if(row(direction, v) == Vector(0, 0, 0)) continue;
    ++number_of_ways;
    sum += fractions[v];
    outcome.are_nodes_held = outcome.are_nodes_held || fractions[v] == 0;
  }
  if(number_of_ways > 0) outcome.mean_fraction = sum / static_cast<double>(number_of_ways);
  return outcome;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_MOTION_OUTCOME_H
