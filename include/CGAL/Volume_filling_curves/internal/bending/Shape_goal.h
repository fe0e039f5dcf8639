// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_GOAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_GOAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Phases in which a curve takes its shape: it bends during the flow, and then it is polished.
enum class Shape_phase
{
  NONE,
  BENDING,
  POLISHING
};

// Length that limits a shape: constant, or in proportion to the thickness; 0 stands for no limit.
struct Shape_length
{
  double length = 0;       // everywhere
  double in_thickness = 0; // in units of the thickness

  double at(double thickness) const { return length + in_thickness * thickness; }
};

// Goal of a shape: the least bend radius, by Rawdon's MinRad, and the least distance between
// strands. Two edges belong to different strands if the curve between them is at least as long as
// half a turn of the tightest bend, or of one around a strand; with less curve in between, the bend
// radius keeps them apart (Schur's comparison theorem).
struct Shape_goal
{
  Shape_length bend_radius, strand_distance;

  bool is_given() const { return bend_radius.at(1) > 0 || strand_distance.at(1) > 0; }

  // returns the same goal for a thickness multiplied by a factor
  Shape_goal in_units_of(double factor) const
  {
    Shape_goal goal = *this;
    goal.bend_radius.in_thickness /= factor;
    goal.strand_distance.in_thickness /= factor;
    return goal;
  }

  // returns the same goal with a share of the bend radius
  Shape_goal with_bends_of(double share) const
  {
    Shape_goal goal = *this;
    goal.bend_radius.length *= share;
    goal.bend_radius.in_thickness *= share;
    return goal;
  }
};

// Limits of a shape at each node. Closing rays have none, and turn at any angle from the curve.
struct Shape_limits
{
  template <typename Network>
  Shape_limits(const Network& curve, const Shape_goal& goal, const std::vector<double>& thickness)
  {
    for(std::size_t v = 0; v < thickness.size(); ++v) {
      bend_radius.push_back(is_at_ray(curve, v) ? 0 : goal.bend_radius.at(thickness[v]));
      strand_distance.push_back(is_in_ray(curve, v) ? 0 : goal.strand_distance.at(thickness[v]));
    }
  }

  std::vector<double> bend_radius, strand_distance;

private:
  template <typename Network>
  static bool is_in_ray(const Network& curve, std::size_t v)
  {
    return curve.is_pinned(v) && curve.origin(v) == Network::null_node();
  }

  template <typename Network>
  static bool is_at_ray(const Network& curve, std::size_t v)
  {
    if(!curve.is_pinned(v)) return false;
    if(is_in_ray(curve, v)) return true;
    for(std::size_t k = 0; k < curve.degree(v); ++k)
      if(is_in_ray(curve, curve.neighbor(v, k))) return true;
    return false;
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_GOAL_H
