// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_GUARDED_STEP_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_GUARDED_STEP_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/flow/Step_size.h>
#include <CGAL/Volume_filling_curves/internal/flow/Strand_separator.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Mean fraction of their displacements that the unpinned nodes moved.
struct Motion_outcome
{
  double mean_fraction = 1; // of their displacements
  bool are_nodes_held = false;

  bool has_moved() const { return mean_fraction > 0; }
  bool is_shortened() const { return mean_fraction < 1; }
};

// Takes the fraction of its displacement that each node moved, and the directions.
inline Motion_outcome motion_outcome(const std::vector<double>& fractions,
                                     const Vector_field& direction)
{
  Motion_outcome outcome;
  double sum = 0;
  std::size_t number_of_moves = 0;
  for(std::size_t v = 0; v < fractions.size(); ++v) {
    if(row(direction, v) == Vector(0, 0, 0)) continue;
    ++number_of_moves;
    sum += fractions[v];
    outcome.are_nodes_held = outcome.are_nodes_held || fractions[v] == 0;
  }
  if(number_of_moves > 0) outcome.mean_fraction = sum / static_cast<double>(number_of_moves);
  return outcome;
}

// Step of a curve along a direction: by the step size, as far as the guard certifies, followed by
// the separation of strands that block one another.
template <typename Guard, typename ConcurrencyTag>
class Guarded_step
{
public:
  // Takes the step size, which notes the outcome of each step.
  Guarded_step(Guard& guard, Step_size& size) : m_guard(guard), m_size(size) {}

  // Sets the distance to which every step moves strands apart, in units of the least thickness.
  void keep_apart(double distance) { m_separation = distance; }

  // Takes the positions of the nodes, the direction of each, and their thicknesses. Returns whether
  // any node moved.
  bool operator()(const Vector_field& positions,
                  const Vector_field& direction,
                  const Curve_flow_parameters& parameters,
                  const std::vector<double>& thickness,
                  Curve_flow_statistics& statistics)
  {
    if(direction.isZero(0)) return false;
    const double scale =
        parameters.time_step > 0 ? parameters.time_step : m_size.next(direction, thickness);
    Vector_field targets = positions + scale * direction;
    project_targets(m_guard.curve(), m_guard.boundary(), targets);
    const Motion_outcome outcome =
        motion_outcome(m_guard.template advance_nodes<ConcurrencyTag>(targets), direction);
    m_size.note_fraction(outcome.mean_fraction);
    if(outcome.is_shortened()) ++statistics.shortened_steps;
    const bool is_separation_due = outcome.are_nodes_held || m_separation > 0;
    const double unit = *std::min_element(thickness.begin(), thickness.end());
    return (is_separation_due && separate_strands(unit, parameters.max_displacement * unit)) ||
           outcome.has_moved();
  }

private:
  // Strands that block one another are separated by more than the length of an edge: at smaller
  // distances the energy does not distinguish them, and would bring them back together.
  bool separate_strands(double min_thickness, double max_motion)
  {
    constexpr double separation_of_held_strands = 0.5; // edges are 0.2 to 0.4 long
    const double distance = (std::max)(separation_of_held_strands, m_separation);
    return Strand_separator<Guard, ConcurrencyTag>(m_guard, distance * min_thickness, max_motion)();
  }

  Guard& m_guard;
  Step_size& m_size;
  double m_separation = 0; // in units of the least thickness
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_GUARDED_STEP_H
