// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SHAPE_FINISH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SHAPE_FINISH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/flow/Step_size.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_stop_rules.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_context.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Returns the shape that is required of an untangled curve; no limits if none are given.
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

// The end of a flow towards a required shape: projections open its tight bends and part its close
// strands until both limits are kept, or until nothing moves any more. They come last, since any
// later change of a few nodes would bend the curve more tightly.
template <typename Flow>
class Shape_finish
{
  using Guard = typename Flow::Guard;
  using Rules = Flow_stop_rules<Flow>;

public:
  Shape_finish(const Untangling_context<Flow>& run, Flow& flow, Rules& rules)
      : m_run(run), m_flow(flow), m_rules(rules)
  {}

  // Takes the status of the flow, and returns that of the run: another one only if it has to stop.
  Untangling_status operator()(Untangling_status status_of_flow)
  {
    m_flow.set_shape(shape_goal(m_run.parameters), Shape_phase::POLISHING);
    Untangling_status status = status_of_flow;
    try {
      for(std::size_t k = 0; k < max_steps && !is_over(); ++k) {
        status = m_rules.status_unless_stopped(status_of_flow);
        if(status != status_of_flow) break;
        step();
      }
    } catch(const Run_stopped&) { // within a step
      status = m_run.status_when_stopped();
    }
    m_flow.set_shape(Shape_goal(), Shape_phase::NONE);
    return status;
  }

  bool has_changed_curve() const { return m_has_changed_curve; }

private:
  // A curve without room for its shape may oscillate forever. In test_untangle_shape, curves with
  // room take one step at most, and one without gives up after 66 (2026-11-29).
  static constexpr std::size_t max_steps = 200;

  bool is_over() const { return m_idle_steps.are_too_many() || m_flow.is_shaped(); }

  void step()
  {
    const bool has_moved = m_flow.step();
    m_has_changed_curve = m_has_changed_curve || has_moved;
    m_idle_steps.note(has_moved);
    m_run.watch.note(m_flow);
    m_run.visitor.on_iteration(m_flow);
  }

  const Untangling_context<Flow>& m_run;
  Flow& m_flow;
  Rules& m_rules;
  Idle_steps m_idle_steps;
  bool m_has_changed_curve = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SHAPE_FINISH_H
