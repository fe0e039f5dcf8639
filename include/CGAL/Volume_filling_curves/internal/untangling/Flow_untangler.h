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
#include <CGAL/Volume_filling_curves/internal/curve/turning.h>
#include <CGAL/Volume_filling_curves/internal/knots/Unknottedness.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Ropelength_descent.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Coarse_phase.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Stall_monitor.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Suspected_unknot.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_context.h>
#include <CGAL/Volume_filling_curves/internal/untangling/looseness.h>
#include <CGAL/Volume_filling_curves/internal/untangling/make_round.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>
#include <CGAL/Volume_filling_curves/internal/untangling/result_without_flow.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The place of a flow in a run.
struct Flow_start
{
  double thickness;              // 0 if it is to be measured
  std::size_t iterations_before; // of other flows
  bool follows_search;           // then what is proved at once is coarse, and flows on
  bool makes_round;              // a single unknot
  std::size_t patience = 1000;   // iterations on a plateau, of what looks like an unknot
  bool is_last = true;           // or else a search follows if it stalls
  bool can_be_thicker = false;   // if that suits the curve, in a flow that follows
};

// Runs the flow until the curve is proved simple, tight, or does not get anywhere.
template <typename Flow, typename Visitor>
class Flow_untangler
{
  using Network = typename Flow::Curve_network;
  using Guard = typename Flow::Guard;

public:
  Flow_untangler(const Untangling_context<Guard, Visitor>& run, const Flow_start& start)
      : m_run(run),
        m_flow(run.guard,
               run.parameters,
               typename Flow::Thickness(start.thickness),
               run.saver.reader()),
        m_start(start)
  {
    State_reader* const reader = run.saver.reader();
    if(!reader) {
      begin_coarsely();
      return;
    }
    m_flow.resume(*reader);
    (*reader)(*this);
  }

  Untangling_result operator()()
  {
    m_run.visitor.on_start(m_flow);
    Untangling_status status = flow();
    try {
      complete(status);
    } catch(const Run_stopped&) { // as far as that has come
    }
    return result(status);
  }

  // Writes or reads what the run depends on between two steps, see State_writer, but for the flow.
  template <typename Archive>
  void serialize(Archive& archive)
  {
    archive(m_unknottedness, m_stall_monitor, m_has_stalled, m_iterations_to_proof,
            m_suspected_unknot, m_number_of_turns, m_are_rays_turning, m_coarse_phase);
  }

private:
  Untangling_status flow()
  {
    try {
      std::optional<Untangling_status> status = status_between_steps();
      for(; !status; status = status_between_steps()) step();
      return *status;
    } catch(const Run_stopped&) { // within a step
      return unless_proved(m_run.status_when_stopped());
    }
  }

  // A step that has begun is completed if states are saved: there are none within a step.
  void step()
  {
    if(m_run.saver.is_saving()) m_run.guard.set_watch(nullptr);
    turn_rays();
    const bool did_move = m_flow.step();
    m_run.watch.note(m_flow);
    m_run.visitor.on_iteration(m_flow);
    const double length = m_flow.length() - m_run.rays.length();
    m_has_stalled = m_stall_monitor(length, m_flow.gradient_norm(), did_move) || !m_run.rays.hold();
    update_coarse_phase(did_move);
    m_run.guard.set_watch(&m_run.watch);
  }

  void complete(Untangling_status& status)
  {
    if(m_coarse_phase.is_on()) flow_coarsely(false);
    if constexpr(!Guard::Boundary::is_bounded)
      if(can_lower_ropelength(status)) status = lower_ropelength(status);
    if(status == Untangling_status::UNKNOTTED && !has_pinned_node(m_flow.curve())) finish();
  }

  // To ask again, as a run does that resumes, changes nothing.
  std::optional<Untangling_status> status_between_steps()
  {
    std::optional<Untangling_status> status = status_before_step();
    if(!status && (m_has_stalled || has_lingered_for_long()))
      status = unless_proved(Untangling_status::STALLED);
    if(!status || is_cut_short(*status))
      m_run.saver.offer(status.has_value(), [this](State_writer& writer) { write_state(writer); });
    return status;
  }

  static bool is_cut_short(Untangling_status status)
  {
    return status == Untangling_status::LIMIT || status == Untangling_status::INTERRUPTED;
  }

  void write_state(State_writer& writer) const
  {
    m_run.write_state(writer);
    writer(m_flow, *this);
  }

  std::optional<Untangling_status> status_before_step()
  {
    m_unknottedness.update(m_flow.curve());
    const bool is_at_rest = is_smooth();
    if(m_unknottedness.is_proved() && (is_at_rest || can_stop_at_proof()))
      return Untangling_status::UNKNOTTED;
    const bool is_slack = is_at_rest && is_loose(m_flow, m_run.parameters.tolerance);
    m_is_too_thin = is_slack && is_too_thin();
    if(m_is_too_thin) return Untangling_status::STALLED;
    if(is_at_rest && !is_slack && !is_suspicious()) return Untangling_status::CONVERGED;
    if(is_at_limit()) return unless_proved(Untangling_status::LIMIT);
    if(m_run.watch.is_interrupted() || !m_run.visitor.go_further(m_flow))
      return Untangling_status::INTERRUPTED;
    return std::nullopt;
  }

  bool is_at_limit() const
  {
    return m_start.iterations_before + m_flow.statistics().iterations >=
               m_run.parameters.number_of_iterations ||
           m_run.watch.is_time_over();
  }

  bool can_stop_at_proof()
  {
    constexpr double largest_turn = 1; // at a node; curves that flow get hardly below 0.7
    if(!is_settled()) return false;
    if(!m_run.parameters.stop_at_proof) return ends_round() && m_flow.length() <= settled_length();
    return !m_start.follows_search || largest_turning_angle(m_flow.curve()) < largest_turn;
  }

  // In a domain a curve may be tight around an obstacle.
  bool is_suspicious()
  {
    return !Guard::Boundary::is_bounded && m_suspected_unknot.is_suspicious(m_flow);
  }

  bool has_lingered_for_long()
  {
    return m_suspected_unknot.has_lingered_for_long(m_flow, m_start.patience);
  }

  // likewise
  bool ends_round() const
  {
    return !m_run.parameters.stop_at_proof && m_flow.curve().number_of_components() == 1 &&
           !Guard::Boundary::is_bounded;
  }

  // A curve on its way from the proof to where it settles has got there already.
  Untangling_status unless_proved(Untangling_status status) const
  {
    return m_run.parameters.stop_at_proof && m_unknottedness.is_proved()
               ? Untangling_status::UNKNOTTED
               : status;
  }

  // Whether the curve is smooth on the scale of the thickness. While rays turn, it flows on.
  bool is_smooth()
  {
    if(m_coarse_phase.is_on() || m_flow.gradient_norm() >= m_run.parameters.tolerance) return false;
    if(!m_are_rays_turning) m_are_rays_turning = !m_run.rays.can_turn_outwards();
    return !m_are_rays_turning || m_number_of_turns == most_turns;
  }

  // Whether a loose curve is not worth the way: loops of radius r / gradient have to shrink, by the
  // largest displacement at a time. Where the thickness may be chosen, a larger one is faster.
  bool is_too_thin() const
  {
    const std::size_t most = m_run.parameters.number_of_iterations;
    const std::size_t done = m_start.iterations_before + m_flow.statistics().iterations;
    return m_start.can_be_thicker || m_flow.gradient_norm() * m_run.parameters.max_displacement *
                                             static_cast<double>(most - (std::min)(most, done)) <
                                         1;
  }

  void begin_coarsely()
  {
    m_unknottedness.update(m_flow.curve());
    if(!can_flow_coarsely() || is_at_limit()) return;
    m_coarse_phase.begin(m_flow.gradient_norm());
    if(m_coarse_phase.is_on()) flow_coarsely(true);
  }

  void update_coarse_phase(bool did_move)
  {
    const bool was_on = m_coarse_phase.is_on();
    m_coarse_phase.note(m_flow.length());
    if(!did_move || !can_flow_coarsely()) m_coarse_phase.end();
    if(m_coarse_phase.is_on() != was_on) flow_coarsely(!was_on);
  }

  // An unknot that is proved is about to end.
  bool can_flow_coarsely() const
  {
    return m_run.parameters.spacing < coarse_spacing && !m_unknottedness.is_proved();
  }

  void flow_coarsely(bool is_coarse)
  {
    const Untangling_parameters& asked = m_run.parameters;
    m_flow.set_max_displacement((is_coarse ? coarse_step : 1) * asked.max_displacement);
    m_flow.set_spacing(is_coarse ? coarse_spacing : asked.spacing);
  }

  // Where the ends are close together, a knot settles around a ray.
  void turn_rays()
  {
    if(!m_are_rays_turning || m_number_of_turns == most_turns) return;
    ++m_number_of_turns;
    if(m_run.rays.turn_outwards(clearance_of_rays * m_flow.thickness()))
      m_flow.set_parameters(m_flow.parameters()); // takes note of where the rays are
    m_are_rays_turning = !m_run.rays.can_turn_outwards();
  }

  // Where on its way a curve is proved to be an unknot depends on details, while its length falls
  // fast. It flows on for a few iterations, to a length that depends on the thickness only. An
  // input that is an unknot from the start stays as it is. \pre it is unknotted
  bool is_settled()
  {
    const std::size_t iterations = m_flow.statistics().iterations;
    if(!m_iterations_to_proof) m_iterations_to_proof = iterations;
    return is_unknot_from_start() || m_flow.length() <= settled_length() ||
           iterations - *m_iterations_to_proof >= most_iterations_to_settle;
  }

  // The polygon that a search has found is no input.
  bool is_unknot_from_start() const
  {
    return m_iterations_to_proof == std::size_t(0) && !m_start.follows_search;
  }

  double settled_length() const
  {
    constexpr double length_over_thickness = 8; // of a component
    const std::size_t number_of_components = m_flow.curve().number_of_components();
    return length_over_thickness * m_flow.thickness() * static_cast<double>(number_of_components);
  }

  // The last step went too far.
  void finish()
  {
    const bool is_input = m_run.parameters.stop_at_proof && is_unknot_from_start();
    const bool is_settling = m_run.parameters.stop_at_proof || ends_round();
    if(is_settling && !is_input && m_flow.length() <= settled_length())
      rescale_to_length(m_run.guard, settled_length());
    if(ends_round() || (m_start.makes_round && m_flow.curve().number_of_components() == 1))
      m_is_round = make_round(m_run.guard);
    m_flow.update();
  }

  // The descent knows no walls.
  bool can_lower_ropelength(Untangling_status status) const
  {
    const bool is_at_end = status == Untangling_status::CONVERGED ||
                           (status == Untangling_status::STALLED && m_start.is_last);
    return m_run.parameters.lower_ropelength && is_at_end && !m_is_too_thin && !is_at_limit() &&
           m_flow.curve().number_of_components() > 0 && is_closed_everywhere(m_flow.curve()) &&
           !has_pinned_node(m_flow.curve());
  }

  // Returns how the run ended: as the flow, unless it is cut short, or unties what had stalled. The
  // descent has no state of its own: a run that is cut short resumes where it began.
  Untangling_status lower_ropelength(Untangling_status status_of_flow)
  {
    m_run.watch.begin(Run_stage::TIGHTENING);
    Untangling_status status = status_of_flow;
    State_writer start;
    if(m_run.saver.is_saving()) write_state(start);
    Ropelength_descent<Guard, typename Flow::Concurrency_tag> descend(m_run.guard,
                                                                      m_flow.thickness() / 2);
    m_is_ropelength_lowered = descend([&] {
      m_flow.note_step();
      m_run.watch.note(m_flow);
      m_run.visitor.on_iteration(m_flow);
      m_unknottedness.update(m_flow.curve());
      if(m_unknottedness.is_proved())
        status = Untangling_status::UNKNOTTED;
      else if(is_at_limit())
        status = Untangling_status::LIMIT;
      else if(m_run.watch.is_interrupted() || !m_run.visitor.go_further(m_flow))
        status = Untangling_status::INTERRUPTED;
      return status == status_of_flow;
    });
    if(descend.is_stopped() && status == status_of_flow) status = m_run.status_when_stopped();
    if(is_cut_short(status))
      m_run.saver.offer(true, [&](State_writer& writer) { writer.append(start.bytes()); });
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
    m_unknottedness.write(m_flow.curve(), result);
    result.is_round = m_is_round;
    result.is_ropelength_lowered = m_is_ropelength_lowered;
    result.thickness = m_flow.thickness();
    if(m_is_too_thin)
      result.fitting_thickness = fitting_thickness(m_flow, m_run.parameters.tolerance);
    result.gradient_norm = m_flow.gradient_norm();
    result.statistics = m_flow.statistics();
    return result;
  }

  static constexpr std::size_t most_iterations_to_settle = 50;
  static constexpr std::size_t most_turns = 300;
  static constexpr double clearance_of_rays = 0.1; // in units of the thickness
  static constexpr double coarse_spacing = 0.5;    // likewise
  static constexpr double coarse_step = 2.5;       // of the largest displacement asked for

  Untangling_context<Guard, Visitor> m_run;
  Flow m_flow;
  Flow_start m_start;
  Unknottedness<Network> m_unknottedness;
  Stall_monitor m_stall_monitor;
  Coarse_phase m_coarse_phase;
  bool m_has_stalled = false, m_is_too_thin = false;
  std::optional<std::size_t> m_iterations_to_proof;
  Suspected_unknot m_suspected_unknot;
  std::size_t m_number_of_turns = 0;
  bool m_are_rays_turning = false, m_is_round = false, m_is_ropelength_lowered = false;
};

template <typename Flow, typename Guard, typename Visitor>
Untangling_result untangle_by_flow(const Untangling_context<Guard, Visitor>& run,
                                   const Flow_start& start)
{
  run.watch.progress().iterations = 0; // no more of the search
  run.watch.begin(Run_stage::FLOWING);
  try {
    return Flow_untangler<Flow, Visitor>(run, start)();
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
