// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_STEP_SIZE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_STEP_SIZE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Length of a step. From two successive directions, the step that would have made the direction
// vanish is estimated (Barzilai and Borwein 1988). The time step grows towards this estimate, and
// shrinks if the direction turns against the last one or if the guard shortened the step. A
// direction that keeps turning has met the longest stable step: the time step then grows less,
// which makes the curve settle instead of oscillating. The largest displacement is limited. The
// energy is not used: with the spheres held fixed it hardly depends on the quality of the step.
struct Step_size
{
  // A step that cannot be certified is halved at most six times; if it is still too long, the next
  // direction may do better.
  static constexpr double min_fraction = 1. / 64;

  // The limit is in units of the thickness.
  explicit Step_size(double displacement = 0) : max_displacement(displacement) {}

  // Returns the factor of the direction, where each node has its thickness.
  double next(const Vector_field& direction, const std::vector<double>& thickness)
  {
    double longest = 0; // in units of the thickness
    for(std::size_t v = 0; v < thickness.size(); ++v)
      longest = (std::max)(longest, row(direction, v).norm() / thickness[v]);
    if(last_direction.rows() == direction.rows()) adapt(direction);
    last_direction = direction;
    time_step = (std::min)(time_step, max_displacement / longest);
    return time_step;
  }

  // Takes the mean fraction of their displacements that the nodes moved.
  void note_fraction(double mean)
  {
    if(mean < tolerated_fraction) time_step *= after_shortened_step;
  }

  // Nodes were renumbered: node v had the index former[v], or was inserted.
  void renumber(const std::vector<std::uint32_t>& former)
  {
    Vector_field direction = Vector_field::Zero(static_cast<Eigen::Index>(former.size()), 3);
    for(std::size_t v = 0; v < former.size(); ++v)
      if(former[v] < last_direction.rows())
        direction.row(static_cast<Eigen::Index>(v)) = last_direction.row(former[v]);
    last_direction = std::move(direction);
  }

  double max_displacement;
  double time_step = std::numeric_limits<double>::infinity();
  double turns = 0; // of the direction, those long ago less
  Vector_field last_direction;

private:
  // Some nodes that are in the way stay behind by themselves; if most do, the time step is too
  // long.
  static constexpr double tolerated_fraction = 0.5;
  // 1.3 takes 7 % fewer iterations than 1.15 on the paper's curves (2026-11-21)
  static constexpr double max_growth = 1.3;
  // Too small a factor costs the steps until the time step has grown back: four after a turn, which
  // halves growth as well, and two after a shortened step. Too large a one repeats the mistake.
  static constexpr double after_turn = 0.6;
  // a turn is forgotten within some 50 steps: 20 or 100 are as good
  static constexpr double memory_of_turns = 0.98;
  static constexpr double after_shortened_step = 0.7;

  void adapt(const Vector_field& direction)
  {
    const double kept = dot(last_direction, direction) / dot(last_direction, last_direction);
    turns = memory_of_turns * turns + (kept < 0 ? 1 : 0);
    const double growth = 1 + (max_growth - 1) / (1 + turns);
    if(kept < 0)
      time_step *= after_turn;
    else if(kept < 1)
      time_step *= (std::min)(1 / (1 - kept), growth);
    else
      time_step *= growth;
  }
};

// Counter of successive steps in which nothing moved. A few of them do no harm: each step frees
// strands that block one another, and the next may move.
class Idle_steps
{
public:
  void note(bool did_move) { m_count = did_move ? 0 : m_count + 1; }

  // returns whether the flow is stuck
  bool are_too_many() const { return m_count >= most; }

  bool is_valid() const { return m_count >= 0 && m_count <= most; } // of a state that was read

private:
  static constexpr int most = 5;

  int m_count = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_STEP_SIZE_H
