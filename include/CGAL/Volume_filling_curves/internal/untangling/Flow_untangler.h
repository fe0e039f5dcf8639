// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_UNTANGLER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_UNTANGLER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_finish.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_stop_rules.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Shape_finish.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_context.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Flow until the curve is proved unknotted, is tight, or stops making progress, coarse while the
// curve shrinks fast. Closing rays that block the curve turn outwards.
template <typename Flow>
class Flow_untangler
{
  using Guard = typename Flow::Guard;

public:
  Flow_untangler(const Untangling_context<Flow>& run, const Flow_start& start)
      : m_run(run),
        m_flow(run.guard,
               run.parameters,
               typename Flow::Thickness(start.thickness),
               run.state.is_flowing),
        m_start(start),
        m_state(run.state.flow_run)
  {}

  Untangling_result operator()()
  {
    if(std::exchange(m_run.state.is_flowing, true))
      resume();
    else
      m_state = Flow_run_state();
    if(m_flow.statistics().iterations == 0 && !m_state.coarse_phase.is_on()) begin_coarsely();
    m_run.visitor.on_start(m_flow);
    Untangling_status status = flow();
    try {
      finish(status);
    } catch(const Run_stopped&) { // the curve keeps what was done so far
    }
    m_run.state.is_flowing = false;
    return result(status);
  }

private:
  Untangling_status flow()
  {
    try {
      std::optional<Untangling_status> status = status_between_steps();
      for(; !status; status = status_between_steps()) step();
      return *status;
    } catch(const Run_stopped&) { // within a step
      return m_rules.unless_proved(m_run.status_when_stopped());
    }
  }

  // A step that has begun is completed if states are saved: there are none within a step.
  void step()
  {
    if(m_run.watch.is_saving()) m_run.guard.set_watch(nullptr);
    turn_rays();
    const bool did_move = m_flow.step();
    m_run.watch.note(m_flow);
    m_run.visitor.on_iteration(m_flow);
    m_rules.note_step(did_move);
    update_coarse_phase(did_move);
    m_run.guard.set_watch(&m_run.watch);
  }

  // Asking again, as a resumed run does, changes nothing.
  std::optional<Untangling_status> status_between_steps()
  {
    const std::optional<Untangling_status> status = m_rules.status(is_smooth());
    if(!status || is_cut_short(*status))
      pass(status ? Run_watch::Checkpoint::END : Run_watch::Checkpoint::STEP);
    return status;
  }

  static bool is_cut_short(Untangling_status status)
  {
    return status == Untangling_status::LIMIT || status == Untangling_status::INTERRUPTED;
  }

  void resume()
  {
    m_flow.resume(m_state.flow, parameters(m_state.coarse_phase.is_on()),
                  typename Flow::Thickness(m_state.thickness));
  }

  void pass(Run_watch::Checkpoint checkpoint)
  {
    if(!m_run.watch.is_saving()) return;
    m_state.thickness = m_flow.thickness();
    m_state.flow = m_flow.state();
    m_run.watch.checkpoint(checkpoint);
  }

  // Whether the curve is smooth on the scale of the thickness. While rays turn, it flows on.
  bool is_smooth()
  {
    if(m_state.coarse_phase.is_on() || !(m_flow.gradient_norm() < m_run.parameters.tolerance))
      return false; // also for NaN
    if(!m_state.are_rays_turning) m_state.are_rays_turning = !m_run.rays.can_turn_outwards();
    return !m_state.are_rays_turning || m_state.turns_of_rays == max_turns;
  }

  // If the ends are close together, a knot may settle around a ray.
  void turn_rays()
  {
    if(!m_state.are_rays_turning || m_state.turns_of_rays == max_turns) return;
    ++m_state.turns_of_rays;
    if(m_run.rays.turn_outwards(clearance_of_rays * m_flow.thickness()))
      m_flow.set_parameters(m_flow.parameters()); // records the positions of the rays
    m_state.are_rays_turning = !m_run.rays.can_turn_outwards();
  }

  void begin_coarsely()
  {
    m_rules.look_for_proof();
    if(!can_flow_coarsely() || m_rules.is_at_limit()) return;
    m_state.coarse_phase.begin(m_flow.gradient_norm());
    if(m_state.coarse_phase.is_on()) flow_coarsely(true);
  }

  void update_coarse_phase(bool did_move)
  {
    const bool was_on = m_state.coarse_phase.is_on();
    m_state.coarse_phase.note(m_flow.length());
    if(!did_move || !can_flow_coarsely()) m_state.coarse_phase.end();
    if(m_state.coarse_phase.is_on() != was_on) flow_coarsely(!was_on);
  }

  // An unknot that is proved is about to end.
  bool can_flow_coarsely() const
  {
    return m_run.parameters.spacing < coarse_spacing && !m_rules.is_proved();
  }

  Curve_flow_parameters parameters(bool is_coarse) const
  {
    Curve_flow_parameters parameters = m_run.parameters;
    parameters.max_displacement *= is_coarse ? coarse_step : 1;
    if(is_coarse) parameters.spacing = coarse_spacing;
    return parameters;
  }

  void flow_coarsely(bool is_coarse)
  {
    m_flow.set_max_displacement(parameters(is_coarse).max_displacement);
    m_flow.set_spacing(parameters(is_coarse).spacing);
  }

  // What follows the flow has no state of its own: a run that is cut short resumes from its end.
  void finish(Untangling_status& status)
  {
    const bool is_cut_short_before = is_cut_short(status);
    if(!is_cut_short_before) pass(Run_watch::Checkpoint::PART);
    if(m_state.coarse_phase.is_on()) flow_coarsely(false);
    if constexpr(!Guard::Boundary::is_bounded)
      if(m_finish.can_lower_ropelength(status)) status = lower_ropelength(status);
    if(status == Untangling_status::UNKNOTTED && !has_constrained_node(m_flow.curve()))
      m_finish.settle();
    if(takes_shape(status)) status = m_shape_finish(status);
    if(!is_cut_short_before && is_cut_short(status))
      m_run.watch.checkpoint(Run_watch::Checkpoint::END_IN_PART);
  }

  bool takes_shape(Untangling_status status) const
  {
    return shape_goal(m_run.parameters).is_given() && !is_cut_short(status) &&
           (status != Untangling_status::STALLED || m_start.is_last);
  }

  Untangling_status lower_ropelength(Untangling_status status_of_flow)
  {
    const Untangling_status status = m_finish.lower_ropelength(status_of_flow);
    try {
      m_flow.update();
    } catch(const Run_stopped&) { // the gradient is that of the motion before
    }
    return status;
  }

  Untangling_result result(Untangling_status status)
  {
    Untangling_result result;
    result.status = status;
    m_rules.write_proofs(result);
    result.is_round = m_finish.is_round() && !m_shape_finish.has_changed_curve();
    result.is_ropelength_lowered = m_finish.is_ropelength_lowered();
    result.thickness = m_flow.thickness();
    result.fitting_thickness = m_rules.fitting_thickness();
    result.gradient_norm = m_flow.gradient_norm();
    result.statistics = m_flow.statistics();
    return result;
  }

  static constexpr std::size_t max_turns = 300;    // a ray takes 63 for half of a turn
  static constexpr double clearance_of_rays = 0.1; // in units of the thickness, as for strands
  // Edges 2.5 times as long as the default, in the same units, and steps longer in proportion.
  static constexpr double coarse_spacing = 0.5, coarse_step = 2.5;

  Untangling_context<Flow> m_run;
  Flow m_flow;
  Flow_start m_start;
  Flow_run_state& m_state;
  Flow_stop_rules<Flow> m_rules{m_run, m_flow, m_start};
  Flow_finish<Flow> m_finish{m_run, m_flow, m_start, m_rules};
  Shape_finish<Flow> m_shape_finish{m_run, m_flow, m_rules};
};

template <typename Flow>
Untangling_result untangle_by_flow(const Untangling_context<Flow>& run, const Flow_start& start)
{
  run.watch.progress().iterations = 0; // no more of the search
  run.watch.begin(Run_stage::FLOWING);
  try {
    return Flow_untangler<Flow>(run, start)();
  } catch(const Run_stopped&) { // before the first step
    Untangling_result result = result_without_flow(run.guard.curve(), run.status_when_stopped());
    result.thickness = start.thickness;
    result.gradient_norm = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_UNTANGLER_H
