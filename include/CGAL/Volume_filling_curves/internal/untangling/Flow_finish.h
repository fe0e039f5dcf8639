// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_FINISH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_FINISH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Ropelength_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_stop_rules.h>
#include <CGAL/Volume_filling_curves/internal/untangling/make_round.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// What a flow is followed by where it ends: a descent to a lower ropelength, and for unknots the
// length that they settle at and a round shape.
template <typename Flow, typename Visitor>
class Flow_finish
{
  using Guard = typename Flow::Guard;
  using Rules = Flow_stop_rules<Flow, Visitor>;

public:
  Flow_finish(const Untangling_context<Guard, Visitor>& run,
              Flow& flow,
              const Flow_start& start,
              Rules& rules)
      : m_run(run), m_flow(flow), m_start(start), m_rules(rules)
  {}

  // The descent knows no walls.
  bool can_lower_ropelength(Untangling_status status) const
  {
    const bool is_at_end = status == Untangling_status::CONVERGED ||
                           (status == Untangling_status::STALLED && m_start.is_last);
    return !Guard::Boundary::is_bounded && m_run.parameters.lower_ropelength && is_at_end &&
           !m_rules.is_curve_too_thin() && !m_rules.is_at_limit() &&
           m_flow.curve().number_of_components() > 0 && is_closed_everywhere(m_flow.curve()) &&
           !has_pinned_node(m_flow.curve());
  }

  // Returns how the run ended: as the flow, unless it is cut short, or unties what had stalled.
  Untangling_status lower_ropelength(Untangling_status status_of_flow)
  {
    m_run.watch.begin(Run_stage::TIGHTENING);
    Untangling_status status = status_of_flow;
    Ropelength_descent<Guard, typename Flow::Concurrency_tag> descend(m_run.guard,
                                                                      m_flow.thickness() / 2);
    m_is_ropelength_lowered = descend([&] {
      m_flow.note_step();
      m_run.watch.note(m_flow);
      m_run.visitor.on_iteration(m_flow);
      status = m_rules.status_beyond(status_of_flow);
      return status == status_of_flow;
    });
    if(descend.is_stopped() && status == status_of_flow) status = m_run.status_when_stopped();
    return status;
  }

  // Gives unknots the length that they settle at, since the last step went too far, and a round
  // shape.
  void settle()
  {
    const bool stops_at_proof = m_run.parameters.stop_at_proof;
    const bool is_input = stops_at_proof && m_rules.is_unknot_from_start();
    const bool is_settling = stops_at_proof || m_rules.ends_round();
    if(is_settling && !is_input && m_flow.length() <= m_rules.settled_length())
      rescale_to_length(m_run.guard, m_rules.settled_length());
    if(m_rules.ends_round() || (m_start.makes_round && m_flow.curve().number_of_components() == 1))
      m_is_round = make_round(m_run.guard);
    m_flow.update();
  }

  bool is_round() const { return m_is_round; }
  bool is_ropelength_lowered() const { return m_is_ropelength_lowered; }

private:
  const Untangling_context<Guard, Visitor>& m_run;
  Flow& m_flow;
  const Flow_start& m_start;
  Rules& m_rules;
  bool m_is_round = false, m_is_ropelength_lowered = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_FINISH_H
