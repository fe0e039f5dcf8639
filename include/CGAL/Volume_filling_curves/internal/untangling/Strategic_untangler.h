// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_STRATEGIC_UNTANGLER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_STRATEGIC_UNTANGLER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/knots/Unknot_proofs.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Curve_search.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_untangler.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_context.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Untangling by the flow, by a random search, or by both. The search unties knots that no flow
// does, and others within milliseconds, but ends with a coarse, irregular polygon; the flow makes
// it even and smooth. If the search finds nothing simpler, the flow starts from the input. If the
// flow jams, the search runs again, for longer, and the next flow is thinner.
template <typename Flow>
class Strategic_untangler
{
  using Network = typename Flow::Curve_network;

public:
  explicit Strategic_untangler(const Untangling_context<Flow>& run)
      : m_run(run), m_curve(run.guard.curve()), m_thickness(run.state.thickness), m_search(run)
  {}

  Untangling_result operator()()
  {
    if(m_run.parameters.strategy == Untangling_strategy::FLOW || !can_search())
      return fitting_flow();
    Untangling_status status =
        m_run.state.is_flowing ? Untangling_status::CONVERGED : prepare_flow();
    while(m_run.parameters.strategy == Untangling_strategy::AUTO &&
          status == Untangling_status::CONVERGED) {
      const Untangling_result last = fitting_flow();
      if(last.status != Untangling_status::STALLED || last.fitting_thickness > 0 ||
         !m_search.can_be_repeated())
        return last;
      status = prepare_flow();
    }
    return completed(result_without_flow(m_curve, status));
  }

private:
  // Factor of the thickness after a flow has jammed. Thinner flows get further, but are slower; the
  // last of four has a third of the thickness.
  static constexpr double thinning = 0.7;
  static constexpr double thickness_of_rings = 0.025; // in units of the length: 100 to 200 edges

  // The search might take the curve out of the sphere of rays, or sliding nodes off their sets.
  bool can_search() const { return !m_run.rays.are_needed() && !has_sliding_node(m_curve); }

  // Searches, and sets the thickness of the flow that follows.
  Untangling_status prepare_flow()
  {
    const bool has_jammed = m_search.state().searches > 0;
    const Untangling_status status = search();
    if(m_thickness > 0)
      m_thickness *= has_jammed ? thinning : 1;
    else if(!has_jammed && is_ring()) // a ring has no distance between strands to measure
      m_thickness = thickness_of_rings * total_length(m_curve);
    return status;
  }

  // Has no state of its own: a run that is cut short resumes where the search began.
  Untangling_status search()
  {
    m_run.watch.checkpoint(Run_watch::Checkpoint::PART);
    const Untangling_status status = m_search();
    if(status == Untangling_status::LIMIT || status == Untangling_status::INTERRUPTED)
      m_run.watch.checkpoint(Run_watch::Checkpoint::END_IN_PART);
    return status;
  }

  bool is_ring() const
  {
    return m_curve.number_of_components() == 1 && unknot_proof(m_curve, 0) != Unknot_proof::NONE;
  }

  // A measured thickness may be too small: parallel strands, as along a ribbon, do not reflect the
  // size of the curve. Another flow then uses a fitting thickness.
  Untangling_result fitting_flow()
  {
    Untangling_result result = flow();
    while(can_be_thicker() && result.fitting_thickness > 0) {
      m_thickness = result.fitting_thickness;
      result = flow();
    }
    return result;
  }

  bool can_be_thicker() const { return m_run.parameters.thickness == 0; }

  Untangling_result flow()
  {
    const bool is_after_search = m_search.state().searches > 0;
    Curve_flow_statistics& statistics = m_run.state.statistics;
    Flow_start start{m_thickness, statistics.iterations, m_search.state().has_changed_curve,
                     is_after_search};
    if(is_after_search && !m_search.is_last()) start.patience = 0; // a search is faster
    start.is_last = !is_after_search || !m_search.can_be_repeated();
    start.can_be_thicker = can_be_thicker();
    const Untangling_result result = untangle_by_flow(m_run, start);
    statistics += result.statistics;
    return completed(result);
  }

  Untangling_result completed(Untangling_result result) const
  {
    result.statistics = m_run.state.statistics;
    result.searches = m_search.state().searches;
    result.sweeps = m_search.state().sweeps;
    return result;
  }

  Untangling_context<Flow> m_run;
  const Network& m_curve;
  double& m_thickness; // of the next flow; 0 if it is to be measured
  Curve_search<Flow> m_search;
};

// The whole space as the surroundings of an Untangling_run: all strategies, and rays at pinned
// ends.
template <typename Traits, typename ConcurrencyTag>
struct Whole_space
{
  using Guard = Isotopy_guard_3<Traits>;
  using Network = typename Guard::Curve_network;
  using Flow = Curve_flow_3<Traits, Unbounded_domain_3<Traits>, ConcurrencyTag>;

  void check(const Network&, const Untangling_parameters&) const {}

  Guard guard(Network& curves) const { return Guard(curves); }

  // A run that is stopped before the thickness is known adds no rays and starts no flow.
  void add_rays(Closing_rays<Guard>& rays, Untangling_parameters& parameters) const
  {
    try {
      rays.template grow<ConcurrencyTag>(parameters);
    } catch(const Run_stopped&) {
    }
  }

  Untangling_result untangle(const Untangling_context<Flow>& run) const
  {
    return Strategic_untangler<Flow>(run)();
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_STRATEGIC_UNTANGLER_H
