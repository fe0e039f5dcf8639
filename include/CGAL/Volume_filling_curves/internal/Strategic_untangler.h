// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STRATEGIC_UNTANGLER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STRATEGIC_UNTANGLER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Untangling_strategy.h>
#include <CGAL/Volume_filling_curves/internal/Curve_simplifier.h>
#include <CGAL/Volume_filling_curves/internal/Strategy_parameters.h>
#include <CGAL/Volume_filling_curves/internal/Tightener.h>
#include <CGAL/Volume_filling_curves/internal/Untangler.h>
#include <CGAL/Volume_filling_curves/internal/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/rescale_to_length.h>

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Whether a visitor wants to hear of the search.
template <typename Visitor, typename = void>
struct Follows_tightening : std::false_type
{};

template <typename Visitor>
struct Follows_tightening<Visitor,
                          std::void_t<decltype(std::declval<Visitor&>().on_tightening(
                              std::declval<const Tightening_progress&>()))>> : std::true_type
{};

// Untangles by the flow, by a random search, or by both: the search unties what no flow does, in
// milliseconds where a flow would, too, but it ends with a coarse and crooked polygon; the flow makes
// that even and smooth. If the flow jams, the search takes its turn again, with more patience, and
// the next flow is thinner.
template <typename Flow, typename ConcurrencyTag, typename Visitor>
class Strategic_untangler
{
  using Network = typename Flow::Curve_network;
  using Guard = Isotopy_guard_3<typename Network::Traits>;

public:
  // The timer has been started.
  Strategic_untangler(Network& curve,
                      Tails<Network>& tails,
                      const Strategy_parameters& strategy,
                      const Curve_flow_parameters& parameters,
                      const Stop_rules& rules,
                      const Real_timer& timer,
                      Visitor& visitor)
      : m_curve(curve),
        m_tails(tails),
        m_strategy(strategy),
        m_parameters(parameters),
        m_rules(rules),
        m_timer(timer),
        m_visitor(visitor),
        m_seeds(strategy.seed)
  {}

  Untangling_result operator()()
  {
    check_parameters(m_parameters);
    // with tails the search might take the curve out of their sphere
    if(m_strategy.strategy == Untangling_strategy::FLOW || m_tails.are_needed()) return flow();
    Untangling_status status = tighten();
    if(m_strategy.strategy == Untangling_strategy::TIGHTEN || status == Untangling_status::LIMIT ||
       status == Untangling_status::INTERRUPTED)
      return result(status);
    m_rules.starts_from_search = true;
    // a ring has no strands whose distance could be measured
    if(!(m_parameters.thickness > 0) && status == Untangling_status::UNKNOTTED &&
       m_curve.number_of_components() == 1)
      m_parameters.thickness = thickness_of_rings * length(m_curve);
    for(;;) {
      const Untangling_result last = flow();
      if(last.status != Untangling_status::STALLED || m_tightenings == max_tightenings) return last;
      status = tighten();
      if(status == Untangling_status::LIMIT || status == Untangling_status::INTERRUPTED)
        return result(status);
      if(m_parameters.thickness > 0) m_parameters.thickness *= thinning;
    }
  }

private:
  static constexpr std::size_t max_tightenings = 4;
  static constexpr double thinning = 0.7, patience_growth = 4;
  static constexpr double thickness_of_rings = 0.025; // in units of the length: 100 to 200 edges

  // The search, until it gets no further. An unknot is proved later, by the flow or the result. The
  // search shrinks the curve by orders of magnitude, which is undone.
  Untangling_status tighten()
  {
    const double start_length = length(m_curve);
    {
      Guard guard(m_curve);
      Curve_simplifier<Guard>(guard, std::numeric_limits<double>::infinity()).run();
      guard.collect_garbage();
      count(guard);
    }
    Guard guard(m_curve);
    Tightener<Guard, ConcurrencyTag> tightener(guard, m_tightening, m_strategy.number_of_chains,
                                               m_seeds.bits());
    Untangling_status status = Untangling_status::CONVERGED;
    tightener.run([&] {
      if(m_timer.time() >= m_rules.time_limit || has_used_up_sweeps(tightener.progress()))
        status = Untangling_status::LIMIT;
      else if(!go_further(tightener.progress()))
        status = Untangling_status::INTERRUPTED;
      return status == Untangling_status::CONVERGED;
    });
    tightener.apply();
    guard.collect_garbage();
    count(guard);
    if(!has_pinned_node(m_curve)) rescale_to_length(m_curve, start_length);
    ++m_tightenings;
    m_sweeps += tightener.progress().sweeps;
    m_tightening.patience_factor *= patience_growth;
    return tightener.has_reached_goal() ? Untangling_status::UNKNOTTED : status;
  }

  // Of the search alone a sweep is an iteration.
  bool has_used_up_sweeps(const Tightening_progress& progress) const
  {
    return m_strategy.strategy == Untangling_strategy::TIGHTEN &&
           m_sweeps + progress.sweeps >= m_rules.max_iterations;
  }

  bool go_further(const Tightening_progress& progress)
  {
    if constexpr(Follows_tightening<Visitor>::value)
      return m_visitor.on_tightening(progress);
    else
      return true;
  }

  Untangling_result flow()
  {
    Untangler<Flow, Visitor> untangler(m_curve, m_tails, m_parameters, m_rules, m_timer, m_visitor);
    const Untangling_result result = untangler();
    m_rules.max_iterations -= result.statistics.iterations;
    add(result.statistics);
    return completed(result);
  }

  // of a curve that did not flow
  Untangling_result result(Untangling_status status)
  {
    Untangling_result result;
    result.status = status;
    for(std::size_t c = 0; c < m_curve.number_of_components(); ++c)
      result.proofs.push_back(unknot_proof(m_curve, c));
    result.link = Link_triviality<Network>(m_curve)(result.proofs);
    return completed(result);
  }

  Untangling_result completed(Untangling_result result) const
  {
    result.statistics = m_statistics;
    result.tightenings = m_tightenings;
    result.sweeps = m_sweeps;
    return result;
  }

  void add(const Curve_flow_statistics& other)
  {
    m_statistics.iterations += other.iterations;
    m_statistics.certified_changes += other.certified_changes;
    m_statistics.refused_changes += other.refused_changes;
    m_statistics.shortened_steps += other.shortened_steps;
    m_statistics.refused_remeshing += other.refused_remeshing;
    m_statistics.seconds_medial_spheres += other.seconds_medial_spheres;
    m_statistics.seconds_direction += other.seconds_direction;
    m_statistics.seconds_motion += other.seconds_motion;
    m_statistics.seconds_remeshing += other.seconds_remeshing;
  }

  void count(const Guard& guard)
  {
    m_statistics.certified_changes += guard.number_of_certified_changes();
    m_statistics.refused_changes += guard.number_of_refused_changes();
  }

  Network& m_curve;
  Tails<Network>& m_tails;
  Strategy_parameters m_strategy;
  Curve_flow_parameters m_parameters;
  Tightening_parameters m_tightening;
  Stop_rules m_rules;
  const Real_timer& m_timer;
  Visitor& m_visitor;
  Random_source m_seeds;
  Curve_flow_statistics m_statistics;
  std::size_t m_tightenings = 0, m_sweeps = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STRATEGIC_UNTANGLER_H
