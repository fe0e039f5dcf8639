// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/guard/Motion_record.h>
#include <CGAL/Volume_filling_curves/internal/knots/Link_triviality.h>
#include <CGAL/Volume_filling_curves/internal/knots/Unknot_proofs.h>
#include <CGAL/Volume_filling_curves/internal/measures/Doubly_critical_distance.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Default_thickness.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_saver.h>
#include <CGAL/Volume_filling_curves/internal/state/run_fingerprint.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_visitor.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Closing_rays.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Shape_finish.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_context.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Run of untangle(): checks the curves, untangles them through a guard by a strategy, with closing
// rays at open ends, and keeps the tighter one of input and result. The `Surroundings`, the whole
// space or a domain, check the curves, make their guard and provide the strategies.
template <typename Surroundings>
class Untangling_run
{
  using Flow = typename Surroundings::Flow;
  using Guard = typename Surroundings::Guard;
  using Network = typename Guard::Curve_network;
  using Shape_point = Curve_flow_traits_3<>::Point_3; // of an Untangling_result

public:
  Untangling_run(Network& curves,
                 const Surroundings& surroundings,
                 const Untangling_parameters& parameters,
                 Run_visitor<Flow>& visitor)
      : m_curves(curves),
        m_surroundings(surroundings),
        m_parameters(parameters),
        m_visitor(visitor),
        m_watch(parameters.time_limit, parameters.progress, Run_watch::moment)
  {}

  Untangling_result operator()()
  {
    m_watch.begin(Run_stage::PREPARING);
    if(!does_in_time(m_watch, [this] { check(); })) return unchecked();
    m_surroundings.check(m_curves, m_parameters);
    Network input = m_curves;
    Untangling_result result;
    try {
      result = untangle(total_length(input));
    } catch(const std::invalid_argument&) { // of a state, or of what only the run finds out
      m_curves = std::move(input);
      throw;
    }
    if(is_tighter_than_result(input, result)) keep(std::move(input), result);
    return result;
  }

private:
  void check() const
  {
    check_parameters(m_parameters);
    check_embedded(m_curves);
    check_constraints<typename Guard::Boundary>(m_curves);
    check_thickness(m_parameters.thickness, box_diagonal(m_curves), "the curves");
    if(m_parameters.thickness > 0 &&
       needs_too_many_nodes((std::max)(m_parameters.thickness, min_thickness_for(m_parameters))))
      refuse_value(internal_np::thickness_t(), m_parameters.thickness,
                   "the curves would have more than 20 million nodes with that spacing");
    check_shape();
    if(!m_parameters.keep_length) return;
    for(std::size_t v = 0; v < m_curves.number_of_nodes(); ++v)
      if(!m_curves.is_free(v))
        refuse_value(internal_np::keep_length_t(), "true",
                     "node " + std::to_string(v) +
                         (m_curves.is_pinned(v) ? " is pinned" : " slides") +
                         ", so the curves cannot be scaled");
  }

  // Takes a thickness, or 0 for one that is to be measured. Curves that cannot be searched flow
  // with every strategy.
  bool needs_too_many_nodes(double thickness) const
  {
    return thickness > 0 &&
           has_too_many_nodes(total_length(m_curves), m_parameters.spacing, thickness);
  }

  void check_shape() const
  {
    const double size = box_diagonal(m_curves);
    const double radius = m_parameters.bend_radius, distance = m_parameters.strand_distance;
    if(radius > size)
      refuse_value(internal_np::bend_radius_t(), radius, not_larger_than("the curves", size));
    if(distance > size)
      refuse_value(internal_np::strand_distance_t(), distance, not_larger_than("the curves", size));
    if(shape_goal(m_parameters).is_given() && m_parameters.strategy == Untangling_strategy::SEARCH)
      refuse_value(internal_np::strategy_t(), m_parameters.strategy,
                   "must be flow or auto if there is a bend_radius or a strand_distance");
  }

  // Result for curves whose check was interrupted, and which are unchanged.
  Untangling_result unchecked() const
  {
    Untangling_result result;
    result.status =
        m_watch.is_interrupted() ? Untangling_status::INTERRUPTED : Untangling_status::LIMIT;
    result.proofs.assign(m_curves.number_of_components(), Unknot_proof::NONE);
    if(is_link(m_curves)) result.link = Link_status::UNDECIDED;
    result.gradient_norm = std::numeric_limits<double>::quiet_NaN();
    certify_no_change(m_curves, m_parameters.certificate);
    return result;
  }

  Untangling_result untangle(double length) // of the input
  {
    Run_saver saver(m_parameters, m_curves, m_watch, [this] { return fingerprint(); });
    saver.resume_curve(
        m_curves, [this](const Network& curves) { m_surroundings.check(curves, m_parameters); });
    Guard guard = m_surroundings.guard(m_curves);
    guard.set_watch(&m_watch);
    if(m_parameters.certificate) guard.start_recording();
    Untangling_state state;
    saver.resume(m_curves, guard, state);
    // Flows get thinner, and rays add length: a state is refused only if it is far beyond the
    // limit.
    constexpr double slack = 100;
    for(const double r : {state.thickness_of_rays, state.thickness, state.flow_run.thickness})
      if(needs_too_many_nodes(slack * r))
        throw Run_state_error("the state contradicts itself: a thickness is too small");
    Untangling_result result = untangle_with_rays(guard, state, saver.is_resuming());
    guard.set_watch(nullptr); // the rest cannot be interrupted
    if(m_parameters.keep_length) rescale(guard, length, result);
    if(shape_goal(m_parameters).is_given()) compare_with_limits(result);
    result.statistics.certified_changes = guard.number_of_certified_changes();
    result.statistics.refused_changes = guard.number_of_refused_changes();
    if(m_parameters.certificate) *m_parameters.certificate = guard.certificate();
    return result;
  }

  Untangling_result untangle_with_rays(Guard& guard, Untangling_state& state, bool is_resuming)
  {
    Untangling_parameters parameters = m_parameters; // adding rays sets the thickness
    Closing_rays<Guard> rays(guard);
    if(is_resuming) {
      rays.set_sphere(state.sphere);
      parameters.thickness = state.thickness_of_rays;
    } else {
      parameters.thickness = thickness_for_shape();
      m_surroundings.add_rays(rays, parameters);
      state.sphere = rays.sphere();
      state.thickness = state.thickness_of_rays = parameters.thickness;
    }
    const Untangling_context<Flow> context{guard, rays, parameters, m_watch, m_visitor, state};
    Untangling_result result = m_surroundings.untangle(context);
    // in a domain, where there are no rays, strands can slip off pinned ends
    const bool can_slip_off = Guard::Boundary::is_bounded && rays.are_needed();
    result.is_closure_kept = !can_slip_off && rays.can_turn_outwards();
    return result;
  }

  // Returns the thickness that is given, or measured, raised to what limits of the shape need; 0 if
  // there are none, and it is to be measured later.
  double thickness_for_shape()
  {
    using Default = Default_thickness<Network, typename Flow::Concurrency_tag>;
    const double least = min_thickness_for(m_parameters);
    double usual = m_parameters.thickness;
    if(least > 0 && usual == 0)
      does_in_time(m_watch, [&] {
        usual = Default(m_curves, m_parameters.number_of_directions, &m_watch)();
      });
    return (std::max)(usual, least);
  }

  // Without the rays, and scaled.
  void compare_with_limits(Untangling_result& result) const
  {
    const Shape_limits limits(m_curves, shape_goal(m_parameters),
                              std::vector<double>(m_curves.number_of_nodes(), result.thickness));
    result.shape_excesses = shape_excesses<Shape_point>(
        Shape_check(typename Flow::Concurrency_tag(), m_curves, limits), Curve_flow_traits_3<>());
    const bool has_settled = result.status == Untangling_status::CONVERGED ||
                             result.status == Untangling_status::UNKNOTTED;
    if(has_settled && !result.shape_excesses.empty())
      result.status = Untangling_status::CONSTRAINT_NOT_REACHED;
  }

  std::string fingerprint() const
  {
    if constexpr(Guard::Boundary::is_bounded)
      return run_fingerprint("untangle in a domain", m_parameters) +
             domain_line(m_surroundings.domain, m_curves.traits());
    else
      return run_fingerprint("untangle", m_parameters);
  }

  static void rescale(Guard& guard, double length, Untangling_result& result)
  {
    const double factor = rescale_to_length(guard, length);
    result.thickness *= factor;
    result.fitting_thickness *= factor;
  }

  // The flow ends about 16 % above the ideal ropelength, and a curve that was tightened otherwise
  // may be below that. Then the input is the better result if it is as simple. A result with a
  // given thickness has that thickness, and stays.
  bool is_tighter_than_result(const Network& input, const Untangling_result& result)
  {
    if(Guard::Boundary::is_bounded || m_parameters.thickness > 0 ||
       shape_goal(m_parameters).is_given() || m_parameters.strategy != Untangling_strategy::AUTO ||
       result.status == Untangling_status::INTERRUPTED || !is_closed_everywhere(input) ||
       has_sliding_node(input))
      return false;
    try {
      return (result.status != Untangling_status::UNKNOTTED || are_unknots(unknot_proofs(input))) &&
             is_tighter(input, m_curves, m_watch);
    } catch(const Run_stopped&) { // the time is over before this is known
      return false;
    }
  }

  // Replaces the result by the input, with an empty record of changes.
  void keep(Network&& input, Untangling_result& result)
  {
    m_curves = std::move(input);
    result.is_input = true;
    result.is_round = false;
    result.is_ropelength_lowered = false;
    result.thickness = 2 * tube_radius(m_curves); // the distance that strands keep
    if(result.status == Untangling_status::UNKNOTTED) result.proofs = unknot_proofs(m_curves);
    certify_no_change(m_curves, m_parameters.certificate);
  }

  static bool are_unknots(const std::vector<Unknot_proof>& proofs)
  {
    return std::find(proofs.begin(), proofs.end(), Unknot_proof::NONE) == proofs.end();
  }

  static std::vector<Unknot_proof> unknot_proofs(const Network& curves)
  {
    std::vector<Unknot_proof> proofs;
    for(std::size_t c = 0; c < curves.number_of_components(); ++c)
      proofs.push_back(unknot_proof(curves, c));
    return proofs;
  }

  Network& m_curves;
  const Surroundings m_surroundings;
  const Untangling_parameters& m_parameters;
  Run_visitor<Flow>& m_visitor;
  Run_watch m_watch;
};

template <typename Surroundings, typename Visitor>
Untangling_result run_untangling(typename Surroundings::Network& curves,
                                 const Surroundings& surroundings,
                                 const Untangling_parameters& parameters,
                                 Visitor& visitor)
{
  Run_visitor_of<typename Surroundings::Flow, Visitor> visitor_of_run(visitor);
  return Untangling_run<Surroundings>(curves, surroundings, parameters, visitor_of_run)();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H
