// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLED_SHAPE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLED_SHAPE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>

#include <algorithm>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The shape that is required of an untangled curve.

// Returns no limits unless some are given.
inline Shape_goal shape_goal(const Untangling_parameters& parameters)
{
  Shape_goal goal;
  goal.bend_radius.length = parameters.bend_radius;
  goal.strand_distance.length = parameters.strand_distance;
  return goal;
}

// The thickness with which the flow brings a curve close to its limits: tight knots have bends of
// at least 0.77 r, and strands 0.96 r apart (6 knots, 2026-11-25). 0 without limits.
inline double min_thickness_for(const Untangling_parameters& parameters)
{
  constexpr double tight_bend_radius = 0.75, tight_strand_distance = 0.95; // in units of r
  return (std::max)(parameters.bend_radius / tight_bend_radius,
                    parameters.strand_distance / tight_strand_distance);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLED_SHAPE_H
