// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_SHAPE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_SHAPE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <algorithm>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The shape that is required of a filling.

// In units of the thickness. With a bend radius of 0.85 r the strands still touch one another; with
// r bends jam before that, and 79 instead of 90 % of the volume are within r.
constexpr double bend_radius_of_thickness = 0.85, strand_distance_of_thickness = 1.6;

// The largest bend radius with which a domain is filled, likewise: with 1.1 r, 68 % are within r.
constexpr double max_bend_radius_of_thickness = 1;

// The largest distance between strands, likewise. With 2 r, the curves of 3 of 25 fillings of a
// box, a cube, a torus and a bunny grew to several times their length, without end; with 1.9 r,
// none did.
constexpr double max_strand_distance_of_thickness = 1.8;

// The least thickness at which a curve with the lengths that are given fills a domain. With less,
// bends would tangle, or contract the curve: in a cube of side 10 r one with a bend radius of 2 r
// vanished.
template <typename Point_3>
double min_thickness_for(const Filling_parameters<Point_3>& parameters)
{
  return (std::max)(parameters.bend_radius / max_bend_radius_of_thickness,
                    parameters.strand_distance / max_strand_distance_of_thickness);
}

// Returns no limits if bends need not be round, and none of the limits is given.
template <typename Point_3>
Shape_goal shape_goal(const Filling_parameters<Point_3>& parameters)
{
  const double radius = parameters.bend_radius, distance = parameters.strand_distance;
  Shape_goal goal;
  if(!parameters.round_bends && !(radius > 0) && !(distance > 0)) return goal;
  goal.bend_radius = {radius, radius > 0 ? 0 : bend_radius_of_thickness};
  goal.strand_distance = {distance, distance > 0 ? 0 : strand_distance_of_thickness};
  return goal;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_SHAPE_H
