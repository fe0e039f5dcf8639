// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_MOTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_MOTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/flow/Flow_thickness.h>
#include <CGAL/Volume_filling_curves/internal/flow/Guarded_step.h>
#include <CGAL/Volume_filling_curves/internal/flow/Remesher.h>
#include <CGAL/Volume_filling_curves/internal/flow/Shaped_step.h>
#include <CGAL/Volume_filling_curves/internal/flow/Step_size.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/support/Stage_timer.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Numbers that the next steps of a flow depend on, besides its parameters, its thickness and the
// curve.
struct Flow_state
{
  std::size_t first_certified_change = 0; // the guard's counts at the start of the flow
  std::size_t first_refused_change = 0;
  Curve_flow_statistics statistics;
  Step_size step_size;
  std::size_t shaped_steps = 0; // in this phase of the shape

  auto members()
  {
    return std::tie(first_certified_change, first_refused_change, statistics, step_size.time_step,
                    step_size.turns, step_size.last_direction, shaped_steps);
  }

  // whether the next step would go forwards, and not to infinity
  bool is_valid() const
  {
    return step_size.time_step > 0 && step_size.turns >= 0 && std::isfinite(step_size.turns);
  }
};

// Motion of a curve along the directions of its flow, followed by remeshing. A curve with a
// required shape takes bending and polishing steps instead of free ones. Near-linear time.
template <typename Guard, typename ConcurrencyTag>
class Flow_motion
{
public:
  // Takes the flow's thickness, which is kept up to date, its parameters, and its state, whose
  // statistics record the time. All must outlive the motion.
  Flow_motion(Guard& guard,
              Flow_thickness<Guard>& thickness,
              Curve_flow_parameters& parameters,
              Flow_state& state)
      : m_guard(guard),
        m_thickness(thickness),
        m_parameters(parameters),
        m_state(state),
        m_step(guard, state.step_size)
  {}

  // Forgets the outcome of the last steps.
  void start_anew()
  {
    m_state.step_size = Step_size(m_parameters.max_displacement);
    m_state.shaped_steps = 0;
  }

  void set_max_displacement(double max_displacement)
  {
    m_parameters.max_displacement = max_displacement;
    m_state.step_size.max_displacement = max_displacement;
  }

  // Sets the distance to which every free step moves strands apart, in units of the least
  // thickness.
  void keep_apart(double distance) { m_step.keep_apart(distance); }

  // Makes the next steps bring the curve into the limits of its shape, see Shaped_step.
  void set_shape(const Shape_goal& goal, Shape_phase phase)
  {
    m_shape = goal;
    m_shape_phase = phase;
  }

  const Shape_goal& shape() const { return m_shape; }

  // Takes the positions of the nodes, and the direction of each. Moves the curve, remeshes it, and
  // returns whether it moved.
  bool operator()(const Vector_field& positions, const Vector_field& direction)
  {
    const bool has_moved =
        m_shape_phase == Shape_phase::POLISHING ? polish() : move(positions, direction);
    remesh();
    return has_moved;
  }

  // Rounds of collapses, which join pairs of edges that are too short, and then of splits, which
  // halve edges that are too long. If the guard's watch ends the run, edges stay as they are.
  void remesh_until_even()
  {
    const Stage_timer stage(m_state.statistics.seconds_remeshing);
    do {
      collect_garbage();
      make_remesher().collapse_short_edges();
    } while(has_garbage() && !must_stop());
    do {
      collect_garbage();
      make_remesher().split_long_edges();
    } while(has_garbage() && !must_stop());
    if(has_garbage()) collect_garbage();
  }

private:
  using Remesher = internal::Remesher<Guard, ConcurrencyTag>;
  using Shaped_step = internal::Shaped_step<Guard, ConcurrencyTag>;

  // Returns whether any node moved.
  bool move(const Vector_field& positions, const Vector_field& direction)
  {
    const Stage_timer stage(m_state.statistics.seconds_motion);
    if(m_shape_phase == Shape_phase::BENDING)
      return shaped_step().bend(direction, m_parameters.max_displacement * m_thickness.min(),
                                m_state.shaped_steps++);
    return m_step(positions, direction, m_parameters, m_thickness.at_nodes(), m_state.statistics);
  }

  Shaped_step shaped_step() { return {m_guard, m_shape, m_thickness.at_nodes()}; }

  // Only folds are remeshed, since a corner at half an edge bends twice as sharply.
  bool polish()
  {
    // More motions reach the limits in fewer steps, but visitors wait for longer, and the curve
    // keeps its length in all but the last.
    constexpr int motions_per_step = 5;
    const Stage_timer stage(m_state.statistics.seconds_motion);
    bool has_moved = false;
    std::optional<Shaped_step> step;
    for(int k = 0; k < motions_per_step && !must_stop(); ++k) {
      const bool is_tense = k + 1 < motions_per_step; // where it is too dense it gets shorter
      has_moved = unfold() || has_moved;
      if(!step || has_garbage() || m_thickness.varies()) {
        collect_garbage();
        step.emplace(m_guard, m_shape, m_thickness.at_nodes());
      }
      if(!step->polish(is_tense)) break;
      has_moved = true;
    }
    return has_moved;
  }

  // Collapses edges that are far shorter than others, and removes nodes at which the curve turns
  // back. Other strands and narrow corners in a fold are nearer than the clearance: with it, a fold
  // in a bunny of 727,559 nodes stayed (2026-11-27). Returns whether the curve changed.
  bool unfold()
  {
    const std::size_t former = m_guard.number_of_certified_changes();
    // Of the least length of an edge: only folds have edges that short. In a prototype, one of
    // 0.0018 r stayed between two corners of 174 degrees in a cube of side 20 r.
    constexpr double fold = 0.25;
    const Clearance_scope<Guard> scope(m_guard, 0);
    Remesher remesher = make_remesher(fold * m_parameters.spacing);
    remesher.collapse_short_edges();
    std::vector<double> min_radii;
    for(const double h : m_thickness.at_nodes()) min_radii.push_back(m_shape.bend_radius.at(h));
    remesher.remove_folds(min_radii);
    return m_guard.number_of_certified_changes() != former;
  }

  void remesh()
  {
    if(m_shape_phase == Shape_phase::POLISHING) return;
    if(m_shape_phase == Shape_phase::BENDING) return remesh_until_even();
    const Stage_timer stage(m_state.statistics.seconds_remeshing);
    Remesher remesher = make_remesher();
    remesher.collapse_short_edges();
    remesher.split_long_edges();
    m_state.statistics.refused_remeshing += remesher.number_of_refusals();
    if(has_garbage()) m_state.step_size.renumber(m_guard.collect_garbage());
  }

  bool has_garbage() const { return m_guard.curve().has_garbage(); }

  void collect_garbage()
  {
    m_state.step_size.renumber(m_guard.collect_garbage());
    m_thickness.update();
  }

  bool must_stop() const { return m_guard.watch() != nullptr && m_guard.watch()->must_stop(); }

  Remesher make_remesher() { return make_remesher(m_parameters.spacing); }

  Remesher make_remesher(double min_edge)
  {
    std::vector<double> spacing = m_thickness.at_nodes();
    for(double& h : spacing) h *= min_edge;
    return {m_guard, std::move(spacing)};
  }

  Guard& m_guard;
  Flow_thickness<Guard>& m_thickness;
  Curve_flow_parameters& m_parameters;
  Flow_state& m_state;
  Guarded_step<Guard, ConcurrencyTag> m_step;
  Shape_goal m_shape;
  Shape_phase m_shape_phase = Shape_phase::NONE;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_MOTION_H
