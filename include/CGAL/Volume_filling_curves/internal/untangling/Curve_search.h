// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_CURVE_SEARCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_CURVE_SEARCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/flow/Curve_simplifier.h>
#include <CGAL/Volume_filling_curves/internal/measures/average_crossing_number.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_search.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Default_thickness.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_context.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Random searches of a run, each longer than the last. A search changes a simplified copy of the
// curve; the curve adopts the result if this leaves less work to the next flow.
template <typename Flow>
class Curve_search
{
  using Guard = typename Flow::Guard;
  using Network = typename Guard::Curve_network;
  using Concurrency_tag = typename Flow::Concurrency_tag;
  using Search = Polygon_search<Guard, Concurrency_tag>;

public:
  explicit Curve_search(const Untangling_context<Flow>& run)
      : m_run(run), m_curve(run.guard.curve()), m_state(run.state.search)
  {
    if(m_state.searches > 0) return; // in a run that was interrupted
    m_state.seeds = Random_source(run.parameters.random_seed);
    // no flow follows that could jam and lead to a search with more patience
    if(is_alone()) m_state.patience_factor = patience_growth;
  }

  // Searches until it stops making progress. An unknot is proved later, by the flow or in the
  // result.
  Untangling_status operator()()
  {
    m_run.watch.begin(Run_stage::SEARCHING);
    const double start = m_run.watch.seconds();
    const Network coarse = simplified(m_curve);
    const double seconds_to_simplify = m_run.watch.seconds() - start;
    if(m_run.watch.must_stop()) return m_run.status_when_stopped();
    Search_parameters parameters;
    parameters.patience_factor = m_state.patience_factor;
    Search search(coarse, parameters, m_run.parameters.number_of_chains, m_state.seeds.bits());
    const Untangling_status status = run(search, start);
    const bool has_jammed = m_state.searches > 0;
    const bool is_interrupted =
        status == Untangling_status::INTERRUPTED || m_run.watch.is_interrupted();
    const bool is_time_to_adopt = is_interrupted ? seconds_to_simplify + search.seconds_to_apply() <
                                                       seconds_after_interruption
                                                 : is_time_left(seconds_to_simplify);
    // no flow follows an interruption
    if(is_time_to_adopt &&
       (!is_flow_next() || is_interrupted || has_jammed || is_simpler(search, coarse)))
      adopt(search);
    ++m_state.searches;
    m_state.sweeps += search.progress().sweeps;
    m_state.patience_factor *= patience_growth;
    m_state.seconds += m_run.watch.seconds() - start;
    if(m_run.watch.is_interrupted()) return Untangling_status::INTERRUPTED;
    if(is_flow_next() && m_run.watch.is_time_over()) return Untangling_status::LIMIT;
    return status;
  }

  bool can_be_repeated() const { return m_state.searches < max_searches && !is_share_used_up(0); }
  bool is_last() const { return m_state.searches >= max_searches; }

  const Search_state& state() const { return m_state; }

private:
  // The last search is 64 times as patient as the first one, see Search_parameters::patience().
  static constexpr std::size_t max_searches = 4;
  static constexpr double patience_growth = 4;
  static constexpr double share_of_searches = 0.25;       // of the time limit, before a flow
  static constexpr double seconds_after_interruption = 5; // which the result of a search is worth

  bool is_alone() const { return m_run.parameters.strategy == Untangling_strategy::SEARCH; }
  bool is_flow_next() const { return m_run.parameters.strategy == Untangling_strategy::AUTO; }

  Untangling_status run(Search& search, double start)
  {
    Untangling_status status = Untangling_status::CONVERGED;
    search.run([&] {
      note(search.progress());
      if(is_alone() && is_at_limit(search))
        status = Untangling_status::LIMIT;
      else if(m_run.watch.is_interrupted() || !m_run.visitor.on_search(search.progress()))
        status = Untangling_status::INTERRUPTED;
      return status == Untangling_status::CONVERGED &&
             (is_alone() || !is_share_used_up(m_run.watch.seconds() - start));
    });
    return status;
  }

  void note(const Search_progress& search) const
  {
    m_run.watch.progress().iterations = m_state.sweeps + search.sweeps;
    m_run.watch.progress().nodes = search.edges;
    m_run.watch.must_stop();
  }

  // A sweep of a search alone is an iteration.
  bool is_at_limit(const Search& search) const
  {
    return !m_run.watch.leaves(search.seconds_to_apply()) ||
           m_state.sweeps + search.progress().sweeps >= m_run.parameters.number_of_iterations;
  }

  // At its end, a run can only complete short work.
  bool is_time_left(double seconds) const
  {
    return (!m_run.watch.is_interrupted() && !m_run.watch.is_time_over()) ||
           seconds < Run_watch::moment;
  }

  bool is_share_used_up(double seconds_of_search) const
  {
    return m_state.seconds + seconds_of_search >= share_of_searches * m_run.parameters.time_limit;
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
  bool is_simpler(const Search& search, const Network& coarse) const
  {
    constexpr double max_crossings_left = 1. / 3;
    constexpr std::size_t stride = 10; // of a hundred directions; 1 ms for a thousand nodes
    if(search.has_reached_goal()) return true;
    const Network found = search.uncertified_result(coarse);
    return average_crossing_number(found, stride) <
               max_crossings_left * average_crossing_number(m_curve, stride) ||
           is_far_shorter(found);
  }

  bool is_far_shorter(const Network& found) const
  {
    constexpr double max_widths_left = 0.1;
    try {
      return length_in_widths(found) < max_widths_left * length_in_widths(m_curve);
    } catch(const Run_stopped&) { // the result is no longer needed
      return false;
    }
  }

  // The length over the distance that strands keep. \throws Run_stopped
  double length_in_widths(const Network& curve) const
  {
    const std::size_t directions = m_run.parameters.number_of_directions;
    const double width =
        Default_thickness<Network, Concurrency_tag>(curve, directions, &m_run.watch)();
    return width > 0 ? total_length(curve) / width : std::numeric_limits<double>::infinity();
  }

  // Applies the changes of the copy to the curve, completely if an interruption has ended the
  // search: its result is the best curve so far. A search shrinks a curve by orders of magnitude;
  // the former length is restored if time allows.
  void adopt(const Search& search)
  {
    m_state.has_changed_curve = true;
    const double length = total_length(m_curve);
    const Clearance_scope<Guard> scope(m_run.guard, 0);
    simplify(m_run.guard, nullptr);
    search.apply(m_run.guard, [&] {
      return !m_run.watch.must_stop() ||
             (m_run.watch.is_interrupted() && !m_run.watch.is_time_over());
    });
    m_run.guard.collect_garbage();
    if(has_constrained_node(m_curve)) return;
    try {
      rescale_to_length(m_run.guard, length);
    } catch(const Run_stopped&) { // the curve then keeps its size
    }
  }

  Untangling_context<Flow> m_run;
  const Network& m_curve;
  Search_state& m_state;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_CURVE_SEARCH_H
