// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_GOAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_GOAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// How a curve gets its shape: it bends while the flow goes on, then it is polished.
enum class Shape_phase
{
  NONE,
  BENDING,
  POLISHING
};

// A length that a shape keeps: the same everywhere, or in proportion to the thickness. None if it
// is 0.
struct Shape_length
{
  double length = 0;       // everywhere
  double in_thickness = 0; // in units of the thickness

  double at(double thickness) const { return length + in_thickness * thickness; }
};

// How tightly a curve may bend, by Rawdon's MinRad, and how close its strands may come. Edges are
// of different strands if the curve between them is half of a turn of the tightest bend, or of one
// around a strand: with less in between, the bends keep them apart (Schur's comparison theorem).
struct Shape_goal
{
  Shape_length bend_radius, strand_distance;

  bool is_given() const { return bend_radius.at(1) > 0 || strand_distance.at(1) > 0; }

  // for a thickness that is the unit of another one times a factor
  Shape_goal in_units_of(double factor) const
  {
    Shape_goal goal = *this;
    goal.bend_radius.in_thickness /= factor;
    goal.strand_distance.in_thickness /= factor;
    return goal;
  }
};

// The same at each node.
struct Shape_limits
{
  Shape_limits(const Shape_goal& goal, const std::vector<double>& thickness)
  {
    for(const double r : thickness) {
      bend_radius.push_back(goal.bend_radius.at(r));
      strand_distance.push_back(goal.strand_distance.at(r));
    }
  }

  std::vector<double> bend_radius, strand_distance;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_GOAL_H
