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
#include <CGAL/Volume_filling_curves/internal/flow/Curve_simplifier.h>
#include <CGAL/Volume_filling_curves/internal/measures/average_crossing_number.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_search.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Default_thickness.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_untangler.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_context.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_strategy.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Untangling by the flow, by a random search, or by both. The search unties knots that no flow
// does, and others within milliseconds, but ends with a coarse, irregular polygon; the flow makes
// it even and smooth. If the search finds nothing simpler, the flow starts from the input. If the
// flow jams, the search runs again, for longer, and the next flow is thinner.
template <typename Flow, typename ConcurrencyTag, typename Visitor>
class Strategic_untangler
{
  using Network = typename Flow::Curve_network;
  using Guard = typename Flow::Guard;
  using Search = Polygon_search<Guard, ConcurrencyTag>;

public:
  explicit Strategic_untangler(const Untangling_context<Guard, Visitor>& run)
      : m_run(run),
        m_curve(run.guard.curve()),
        m_thickness(run.parameters.thickness),
        m_seeds(run.parameters.random_seed)
  {
    // no flow follows that could jam, and be followed by a search with more patience
    if(run.parameters.strategy == Untangling_strategy::SEARCH)
      m_search_parameters.patience_factor = patience_growth;
  }

  Untangling_result operator()()
  {
    const auto kept = m_run.saver.keep([this](State_archive& archive) { copy(archive); });
    // with rays the search might take the curve out of their sphere
    if(m_run.parameters.strategy == Untangling_strategy::FLOW || m_run.rays.are_needed())
      return fitting_flow();
    const bool is_flowing = m_run.saver.is_resuming();
    Untangling_status status = is_flowing ? Untangling_status::CONVERGED : prepare_flow();
    while(m_run.parameters.strategy == Untangling_strategy::AUTO &&
          status == Untangling_status::CONVERGED) {
      const Untangling_result last = fitting_flow();
      if(last.status != Untangling_status::STALLED || last.fitting_thickness > 0 ||
         !can_search_again())
        return last;
      status = prepare_flow();
    }
    return completed(result_without_flow(m_curve, status));
  }

private:
  static constexpr std::size_t max_searches = 4;
  static constexpr double thinning = 0.7, patience_growth = 4;
  static constexpr double thickness_of_rings = 0.025; // in units of the length: 100 to 200 edges
  static constexpr double share_of_searches = 0.25;   // of the time limit, before a flow

  // Searches, and sets the thickness of the flow that follows.
  Untangling_status prepare_flow()
  {
    const bool has_jammed = m_searches > 0;
    const Untangling_status status = search();
    if(m_thickness > 0)
      m_thickness *= has_jammed ? thinning : 1;
    else if(!has_jammed && is_ring()) // which has no strands whose distance could be measured
      m_thickness = thickness_of_rings * total_length(m_curve);
    return status;
  }

  // Has no state of its own: a run that is cut short resumes where the search began.
  Untangling_status search()
  {
    const Run_state start = m_run.saver.state_if_saving();
    const Untangling_status status = search_and_adopt();
    if(status == Untangling_status::LIMIT || status == Untangling_status::INTERRUPTED)
      m_run.saver.offer_last(start);
    return status;
  }

  // Searches from a simplified copy until it stops making progress, and adopts the result. An
  // unknot is proved later, by the flow or in the result.
  Untangling_status search_and_adopt()
  {
    m_run.watch.begin(Run_stage::SEARCHING);
    const double start = m_run.watch.seconds();
    const Network coarse = simplified(m_curve);
    const double seconds_to_simplify = m_run.watch.seconds() - start;
    if(m_run.watch.must_stop()) return m_run.status_when_stopped();
    Search polygon_search(coarse, m_search_parameters, m_run.parameters.number_of_chains,
                          m_seeds.bits());
    Untangling_status status = run(polygon_search, start);
    const bool is_flow_next = m_run.parameters.strategy == Untangling_strategy::AUTO;
    const bool has_jammed = m_searches > 0;
    if(is_time_left(seconds_to_simplify) &&
       (!is_flow_next || has_jammed || is_simpler(polygon_search, coarse)))
      adopt(polygon_search);
    ++m_searches;
    m_sweeps += polygon_search.progress().sweeps;
    m_search_parameters.patience_factor *= patience_growth;
    m_seconds_of_searches += m_run.watch.seconds() - start;
    if(m_run.watch.is_interrupted()) return Untangling_status::INTERRUPTED;
    if(is_flow_next && m_run.watch.is_time_over()) return Untangling_status::LIMIT;
    return status;
  }

  Untangling_status run(Search& polygon_search, double start)
  {
    Untangling_status status = Untangling_status::CONVERGED;
    const bool is_alone = m_run.parameters.strategy == Untangling_strategy::SEARCH;
    polygon_search.run([&] {
      note(polygon_search.progress());
      if(is_alone && is_at_limit(polygon_search))
        status = Untangling_status::LIMIT;
      else if(m_run.watch.is_interrupted() || !m_run.visitor.on_search(polygon_search.progress()))
        status = Untangling_status::INTERRUPTED;
      return status == Untangling_status::CONVERGED &&
             (is_alone || !is_share_used_up(m_run.watch.seconds() - start));
    });
    return status;
  }

  void note(const Search_progress& search) const
  {
    m_run.watch.progress().iterations = m_sweeps + search.sweeps;
    m_run.watch.progress().nodes = search.edges;
    m_run.watch.must_stop();
  }

  // Of the search alone a sweep is an iteration.
  bool is_at_limit(const Search& polygon_search) const
  {
    return !m_run.watch.leaves(polygon_search.seconds_to_apply()) ||
           m_sweeps + polygon_search.progress().sweeps >= m_run.parameters.number_of_iterations;
  }

  // At its end, a run can only complete short work.
  bool is_time_left(double seconds) const
  {
    return (!m_run.watch.is_interrupted() && !m_run.watch.is_time_over()) ||
           seconds < Run_watch::moment;
  }

  bool can_search_again() const { return m_searches < max_searches && !is_share_used_up(0); }

  bool is_share_used_up(double seconds_of_search) const
  {
    return m_seconds_of_searches + seconds_of_search >=
           share_of_searches * m_run.parameters.time_limit;
  }

  static void simplify(Guard& guard, Run_watch* watch)
  {
    Curve_simplifier<Guard>(guard, std::numeric_limits<double>::infinity()).run(watch);
    guard.collect_garbage();
  }

  Network simplified(Network curve) const
  {
    Guard guard(curve);
    simplify(guard, &m_run.watch);
    return curve;
  }

  // Returns whether the flow has less work from the result of a search than from the current curve.
  // Smoothing an irregular polygon takes longer than undoing crossings: for a random polygon of 300
  // edges in a ball, searched from 1943 crossings down to 821, 568 iterations and 12 seconds, and
  // 217 and 4.5 without it; a tight curve of 292 crossings comes back with 329 (2026-11-22).
  // Tangled knots keep about a tenth. A ribbon has few crossings, but is thousands of its own
  // widths long.
  bool is_simpler(const Search& polygon_search, const Network& coarse) const
  {
    constexpr double max_crossings_left = 1. / 3;
    constexpr std::size_t stride = 10; // of a hundred directions; 1 ms for a thousand nodes
    if(polygon_search.has_reached_goal()) return true;
    const Network found = polygon_search.uncertified_result(coarse);
    return average_crossing_number(found, stride) <
               max_crossings_left * average_crossing_number(m_curve, stride) ||
           is_far_shorter(found);
  }

  bool is_far_shorter(const Network& found) const
  {
    constexpr double max_widths_left = 0.1;
    try {
      return length_in_widths(found) < max_widths_left * length_in_widths(m_curve);
    } catch(const Run_stopped&) { // it does not matter any more
      return false;
    }
  }

  // The length over the distance that strands keep. \throws Run_stopped
  double length_in_widths(const Network& curve) const
  {
    const std::size_t directions = m_run.parameters.number_of_directions;
    const double width =
        Default_thickness<Network, ConcurrencyTag>(curve, directions, &m_run.watch)();
    return width > 0 ? total_length(curve) / width : std::numeric_limits<double>::infinity();
  }

  // Applies the changes of the copy to the curve. A search shrinks a curve by orders of magnitude;
  // the former length is restored if time allows.
  void adopt(const Search& polygon_search)
  {
    m_follows_search = true;
    const double length = total_length(m_curve);
    const Clearance_scope<Guard> scope(m_run.guard, 0);
    simplify(m_run.guard, nullptr);
    polygon_search.apply(m_run.guard, [&] { return !m_run.watch.must_stop(); });
    m_run.guard.collect_garbage();
    if(has_pinned_node(m_curve)) return;
    try {
      rescale_to_length(m_run.guard, length);
    } catch(const Run_stopped&) { // the size of the curve means nothing then
    }
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
    Flow_start start{m_thickness, m_statistics.iterations, m_follows_search, m_searches > 0};
    if(m_searches > 0 && m_searches < max_searches) start.patience = 0; // a search gets on faster
    start.is_last = m_searches == 0 || !can_search_again();
    start.can_be_thicker = can_be_thicker();
    const Untangling_result result = untangle_by_flow<Flow>(m_run, start);
    m_statistics += result.statistics;
    return completed(result);
  }

  // state of a run between searches and flows
  void copy(State_archive& archive)
  {
    archive(m_thickness, m_search_parameters.patience_factor, m_seeds, m_statistics, m_searches,
            m_sweeps, m_seconds_of_searches, m_follows_search);
    archive.require(m_thickness == 0 || is_positive(m_thickness));
  }

  Untangling_result completed(Untangling_result result) const
  {
    result.statistics = m_statistics;
    result.searches = m_searches;
    result.sweeps = m_sweeps;
    return result;
  }

  Untangling_context<Guard, Visitor> m_run;
  const Network& m_curve;
  double m_thickness; // of the next flow; 0 if it is to be measured
  Search_parameters m_search_parameters;
  Random_source m_seeds;
  Curve_flow_statistics m_statistics;
  std::size_t m_searches = 0, m_sweeps = 0;
  double m_seconds_of_searches = 0;
  bool m_follows_search = false; // the curve
};

// The whole space as the place of an Untangling_run: all strategies, and rays at pinned ends.
template <typename Traits, typename ConcurrencyTag>
struct Whole_space
{
  using Guard = Isotopy_guard_3<Traits>;
  using Network = typename Guard::Curve_network;
  using Flow = Curve_flow_3<Traits, Unbounded_domain_3<Traits>, ConcurrencyTag>;

  void check(const Network&, const Untangling_parameters&) const {}

  Guard guard(Network& curves) const { return Guard(curves); }

  // If the run is stopped before the thickness is known there are no rays, and nothing flows.
  void add_rays(Closing_rays<Guard>& rays, Untangling_parameters& parameters) const
  {
    try {
      rays.template grow<ConcurrencyTag>(parameters);
    } catch(const Run_stopped&) {
    }
  }

  template <typename Visitor>
  Untangling_result untangle(const Untangling_context<Guard, Visitor>& run) const
  {
    return Strategic_untangler<Flow, ConcurrencyTag, Visitor>(run)();
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_STRATEGIC_UNTANGLER_H
