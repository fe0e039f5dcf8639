// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_STOP_RULES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_STOP_RULES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/knots/Unknot_proofs.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_context.h>
#include <CGAL/Volume_filling_curves/internal/untangling/flow_monitors.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Position of a flow in a run.
struct Flow_start
{
  double thickness;              // 0 if it is to be measured
  std::size_t iterations_before; // of other flows
  bool follows_search;           // the curve is coarse, and flows on even if it is proved at once
  bool makes_round;              // a single unknot
  std::size_t patience = 1000;   // iterations on a plateau of a curve that may be an unknot
  bool is_last = true;           // otherwise a search follows if the flow stalls
  bool can_be_thicker = false;   // whether a flow with a larger thickness may follow
};

// Rules that decide between two steps whether a flow ends, and how: the curve is proved simple, is
// tight or stalls, or the run is at its limit.
//
// The gradient, in units of 1 / r, is also below the tolerance on curves that are loose but smooth
// on the scale of r, such as a loop of radius 143 r. A curve is therefore tight only if contacts
// and bends also balance the pull of its length.
template <typename Flow>
class Flow_stop_rules
{
  using Network = typename Flow::Curve_network;
  using Guard = typename Flow::Guard;

public:
  Flow_stop_rules(const Untangling_context<Flow>& run, const Flow& flow, const Flow_start& start)
      : m_run(run), m_flow(flow), m_start(start), m_state(run.state.flow_run)
  {}

  void note_step(bool did_move)
  {
    const double length = m_flow.length() - m_run.rays.length();
    m_state.has_stalled =
        m_state.stall_monitor(length, m_flow.gradient_norm(), did_move) || !m_run.rays.hold();
  }

  // Takes whether the curve is smooth on the scale of the thickness. Asking again changes nothing.
  std::optional<Untangling_status> status(bool is_smooth)
  {
    look_for_proof();
    if(is_proved() && (is_smooth || can_stop_at_proof())) return Untangling_status::UNKNOTTED;
    const bool is_slack = is_smooth && is_loose();
    m_is_too_thin = is_slack && is_too_thin();
    if(m_is_too_thin) return Untangling_status::STALLED;
    if(is_smooth && !is_slack && !may_be_unknot()) return Untangling_status::CONVERGED;
    if(is_at_limit()) return unless_proved(Untangling_status::LIMIT);
    if(is_interrupted()) return Untangling_status::INTERRUPTED;
    if(m_state.has_stalled || m_state.plateau_monitor.has_lingered(m_flow, m_start.patience))
      return unless_proved(Untangling_status::STALLED);
    return std::nullopt;
  }

  // The status of a flow that continues after its end, unless the run is to stop.
  Untangling_status status_beyond(Untangling_status end)
  {
    look_for_proof();
    return is_proved() ? Untangling_status::UNKNOTTED : status_unless_stopped(end);
  }

  // The status of a curve that takes its shape after the flow, unless the run is to stop.
  Untangling_status status_unless_stopped(Untangling_status end)
  {
    if(is_at_limit()) return Untangling_status::LIMIT;
    return is_interrupted() ? Untangling_status::INTERRUPTED : end;
  }

  // A curve that settles after its proof counts as unknotted.
  Untangling_status unless_proved(Untangling_status status) const
  {
    return m_run.parameters.stop_at_proof && is_proved() ? Untangling_status::UNKNOTTED : status;
  }

  bool is_at_limit() const
  {
    return iterations() >= m_run.parameters.number_of_iterations || m_run.watch.is_time_over();
  }

  // whether the flow has stalled since the thickness is too small for the curve
  bool is_curve_too_thin() const { return m_is_too_thin; }

  // The thickness, at least twice the present one, at which the current loose curve is far from
  // smooth; 0 if the present one is large enough. Ribbons, loops of strands 1e-2 to 1e-11 of their
  // radius apart, come tight from there in 40 to 130 iterations (2026-11-23).
  double fitting_thickness() const
  {
    constexpr double gradient_of_fitting = 0.05;
    const double gradient = (std::max)(gradient_of_fitting, 2 * m_run.parameters.tolerance);
    return m_is_too_thin ? m_flow.thickness() * gradient / m_flow.gradient_norm() : 0;
  }

  // In a domain a curve may be tight around an obstacle.
  bool ends_round() const
  {
    return !m_run.parameters.stop_at_proof && m_flow.curve().number_of_components() == 1 &&
           !Guard::Boundary::is_bounded;
  }

  // The polygon that a search has found is no input.
  bool is_unknot_from_start() const
  {
    return m_state.iterations_to_proof == 0 && !m_start.follows_search;
  }

  double settled_length() const
  {
    // Of a component: more than 5, below which its tension fades, see component_tensions().
    constexpr double length_over_thickness = 8;
    const std::size_t number_of_components = m_flow.curve().number_of_components();
    return length_over_thickness * m_flow.thickness() * static_cast<double>(number_of_components);
  }

  void look_for_proof() { m_state.proofs.update(m_flow.curve()); }
  bool is_proved() const { return m_state.proofs.is_proved(); }
  void write_proofs(Untangling_result& result) { m_state.proofs.write(m_flow.curve(), result); }

private:
  static constexpr std::size_t max_iterations_to_settle = 50;

  // in this flow, and in those before
  std::size_t iterations() const
  {
    return m_start.iterations_before + m_flow.statistics().iterations;
  }

  bool is_interrupted() const
  {
    return m_run.watch.is_interrupted() || !m_run.visitor.go_further(m_flow);
  }

  // Whether contacts and bends leave more than 5 % of the pull of the length. Tight knots have a
  // share of 1.4 times their gradient, 0.01 (236 knots, 2026-11-23); a rough tolerance takes more.
  bool is_loose() const
  {
    constexpr double loose = 0.05, loose_over_tolerance = 2;
    return m_flow.loose_share() >=
           (std::max)(loose, loose_over_tolerance * m_run.parameters.tolerance);
  }

  // Whether tightening a loose curve would take too long: loops of radius r / gradient shrink by at
  // most the largest displacement per step. If the thickness may be chosen, a larger one is faster.
  bool is_too_thin() const
  {
    const std::size_t most = m_run.parameters.number_of_iterations;
    return m_start.can_be_thicker ||
           m_flow.gradient_norm() * m_run.parameters.max_displacement *
                   static_cast<double>(most - (std::min)(most, iterations())) <
               1;
  }

  // In a domain a curve may be tight around an obstacle.
  bool may_be_unknot()
  {
    return !Guard::Boundary::is_bounded && m_state.plateau_monitor.enter_plateau(m_flow);
  }

  bool can_stop_at_proof()
  {
    constexpr double max_turn = 1; // at a node; flowing curves hardly come below 0.7
    if(!is_settled()) return false;
    if(!m_run.parameters.stop_at_proof) return ends_round() && m_flow.length() <= settled_length();
    return !m_start.follows_search || max_turning_angle(m_flow.curve()) < max_turn;
  }

  // When a curve is proved to be an unknot, its length still falls fast and depends on details of
  // the motion. It therefore flows on for a few iterations, to a length that only depends on the
  // thickness. An input that is a proved unknot from the start stays as it is. \pre it is unknotted
  bool is_settled()
  {
    const std::size_t iterations = m_flow.statistics().iterations;
    if(m_state.iterations_to_proof == Flow_run_state::never)
      m_state.iterations_to_proof = iterations;
    return is_unknot_from_start() || m_flow.length() <= settled_length() ||
           iterations - m_state.iterations_to_proof >= max_iterations_to_settle;
  }

  const Untangling_context<Flow>& m_run;
  const Flow& m_flow;
  const Flow_start& m_start;
  Flow_run_state& m_state;
  bool m_is_too_thin = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_STOP_RULES_H
