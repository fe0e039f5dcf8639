// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/Untangling_result.h>
#include <CGAL/Volume_filling_curves/internal/Link_triviality.h>
#include <CGAL/Volume_filling_curves/internal/Stall_monitor.h>
#include <CGAL/Volume_filling_curves/internal/Stop_rules.h>
#include <CGAL/Volume_filling_curves/internal/unknot_proof.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Runs the flow until the curve is proved simple, tight, or does not get anywhere.
template <typename Flow, typename Visitor>
class Untangler
{
  using Network = typename Flow::Curve_network;

public:
  Untangler(Network& curve,
            const Curve_flow_parameters& parameters,
            const Stop_rules& rules,
            Visitor& visitor)
      : m_timer(started_timer()), m_flow(curve, parameters), m_rules(rules), m_visitor(visitor)
  {}

  Untangling_result operator()()
  {
    m_visitor.on_start(m_flow);
    std::optional<Untangling_status> status = status_before_step();
    while(!status) {
      const bool did_move = m_flow.step();
      m_visitor.on_iteration(m_flow);
      const bool is_stalled = m_stall_monitor(m_flow.length(), m_flow.gradient_norm(), did_move);
      status = status_before_step();
      if(!status && is_stalled) status = Untangling_status::STALLED;
    }
    return result(*status);
  }

private:
  std::optional<Untangling_status> status_before_step()
  {
    prove();
    const bool is_converged = m_flow.gradient_norm() < m_rules.tolerance;
    if(is_unknotted() && (m_rules.stop_at_proof || is_converged))
      return Untangling_status::UNKNOTTED;
    if(is_converged) return Untangling_status::CONVERGED;
    if(m_flow.statistics().iterations >= m_rules.max_iterations ||
       m_timer.time() >= m_rules.time_limit)
      return Untangling_status::LIMIT;
    if(!m_visitor.go_further(m_flow)) return Untangling_status::INTERRUPTED;
    return std::nullopt;
  }

  // A proof holds for good: the flow changes the curve by isotopies only.
  void prove()
  {
    const Network& curve = m_flow.curve();
    m_proofs.resize(curve.number_of_components(), Unknot_proof::NONE);
    for(std::size_t c = 0; c < m_proofs.size(); ++c)
      if(m_proofs[c] == Unknot_proof::NONE) m_proofs[c] = unknot_proof(curve, c);
    const bool are_unknots = !m_proofs.empty() && std::find(m_proofs.begin(), m_proofs.end(),
                                                            Unknot_proof::NONE) == m_proofs.end();
    if(m_link == Link_status::UNDECIDED && are_unknots)
      m_link = Link_triviality<Network>(curve)(m_proofs);
  }

  bool is_unknotted() const
  {
    return m_link == Link_status::TRIVIAL ||
           (m_proofs.size() == 1 && m_proofs[0] != Unknot_proof::NONE);
  }

  Untangling_result result(Untangling_status status)
  {
    if(m_link == Link_status::UNDECIDED)
      m_link = Link_triviality<Network>(m_flow.curve())(m_proofs);
    Untangling_result result;
    result.status = status;
    result.proofs = m_proofs;
    result.link = m_link;
    result.thickness = m_flow.thickness();
    result.gradient_norm = m_flow.gradient_norm();
    result.statistics = m_flow.statistics();
    return result;
  }

  static Real_timer started_timer()
  {
    Real_timer timer;
    timer.start();
    return timer;
  }

  Real_timer m_timer; // starts before the flow is prepared
  Flow m_flow;
  Stop_rules m_rules;
  Visitor& m_visitor;
  Stall_monitor m_stall_monitor;
  std::vector<Unknot_proof> m_proofs;
  Link_status m_link = Link_status::UNDECIDED;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLER_H
