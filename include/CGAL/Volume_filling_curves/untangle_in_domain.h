// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_UNTANGLE_IN_DOMAIN_H
#define CGAL_VOLUME_FILLING_CURVES_UNTANGLE_IN_DOMAIN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_untangler.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_run.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {

// A domain as the place of an Untangling_run: the curves flow, and no rays lead out of it.
template <typename Traits, typename Domain, typename ConcurrencyTag>
struct Place_in_domain
{
  using Guard = Isotopy_guard_3<Traits, Domain>;
  using Network = typename Guard::Curve_network;
  using Flow = Curve_flow_3<Traits, Domain, ConcurrencyTag>;

  void check(const Network& curves, const Untangling_parameters& parameters) const
  {
    if(parameters.strategy == Untangling_strategy::SEARCH)
      refuse_value(internal_np::strategy_t(), parameters.strategy,
                   "the search does not know the domain");
    check_inside(curves, domain);
  }

  Guard guard(Network& curves) const { return Guard(curves, domain); }

  void add_rays(Closing_rays<Guard>&, Untangling_parameters&) const {}

  template <typename Visitor>
  Untangling_result untangle(const Untangling_context<Guard, Visitor>& run) const
  {
    return untangle_by_flow<Flow>(run, {run.parameters.thickness, 0, false, false});
  }

  const Domain& domain;
};

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles curves that must not leave a domain: moves them, without ever passing through
 * themselves or the boundary, to a short and simple shape.
 *
 * The curves flow, as `untangle()` lets them without a domain and with the strategy `FLOW`, until
 * they are proved to be unknots, are tight, or get nowhere; the boundary limits the medial spheres
 * and the motion. Obstacles are cavities of the domain. What is proved of the curves is about the
 * curves in space and says nothing of the obstacles: a curve that is an unknot may be hooked around
 * one. With `stop_at_proof(false)` it flows on until it is tight around it. The knots of curves
 * with ends are not kept, even if the ends are pinned: strands may slip off them.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, or a model of
 * `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param domain the domain, or a closed triangle mesh, whose inside it is, as that of a
 * `Triangle_mesh_domain_3`
 * \param np \vfcNamedParams{Untangle_in_mesh_signature}. The `strategy` must not be `SEARCH`;
 * `AUTO` stands for `FLOW`. `lower_ropelength` changes nothing.
 *
 * \returns how the run ended, what is proved of the curves, and statistics
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument as `untangle()` without a domain, if the curves are not strictly
 * inside the domain, with the nodes in the message, and if the `strategy` is `SEARCH`
 * \throws Run_state_error as `untangle()` without a domain
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Traits,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!internal::Are_named_parameters<Domain>::value &&
                               !std::is_same_v<Domain, Untangling_parameters> &&
                               internal::Are_named_parameters<NamedParameters>::value,
                           int> = 0
#endif
          >
Untangling_result untangle(Curve_network_3<Traits>& curves,
                           const Domain& domain,
                           const NamedParameters& np = parameters::default_values())
{
  using Signature =
      std::conditional_t<internal::Is_domain<Domain>::value, internal::Untangle_in_domain_signature,
                         internal::Untangle_in_mesh_signature>;
  const auto parameters = internal::get_parameters<Signature>(np);
  return untangle<ConcurrencyTag>(curves, internal::as_domain<Traits>(domain, np), parameters,
                                  internal::get_visitor(np));
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles a polyline, or several, that must not leave a domain.
 *
 * By \cgal's habit a polyline is closed if its last point repeats the first, and so is then that of
 * the result; the ends of the others are pinned. See the overload for `Curve_network_3`.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Polylines a model of `SequenceContainer` whose items are points, or such containers
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, or a model of
 * `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines, replaced by the result
 * \param domain the domain, or a closed triangle mesh, whose inside it is
 * \param np \vfcNamedParams{Untangle_polylines_in_mesh_signature}
 *
 * \returns how the run ended, what is proved of the curves, and statistics
 *
 * \throws std::invalid_argument as that overload and the constructor of `Curve_network_3` from
 * polylines. The polylines are unchanged then.
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Polylines,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::is_range_of_items<Polylines> &&
                               !internal::Are_named_parameters<Domain>::value,
                           int> = 0
#endif
          >
Untangling_result untangle(Polylines& polylines,
                           const Domain& domain,
                           const NamedParameters& np = parameters::default_values())
{
  using Signature = std::conditional_t<internal::Is_domain<Domain>::value,
                                       internal::Untangle_polylines_in_domain_signature,
                                       internal::Untangle_polylines_in_mesh_signature>;
  const auto parameters = internal::get_parameters<Signature>(np);
  internal::Polylines_in_place<Polylines, NamedParameters> in_place(polylines, np);
  using Traits = typename decltype(in_place)::Network::Traits;
  const Untangling_result result =
      untangle<ConcurrencyTag>(in_place.curves(), internal::as_domain<Traits>(domain, np),
                               parameters, internal::get_visitor(np));
  in_place.store();
  return result;
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles curves inside a domain, with a struct of parameters in place of named ones.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, or a model of
 * `FaceListGraph`
 * \tparam Visitor a model of `CurveFlowVisitor`, or a `std::reference_wrapper` of one
 *
 * \param curves the curves, replaced by the result
 * \param domain the domain, or a closed triangle mesh, whose inside it is
 * \param parameters the parameters
 * \param visitor is told of the progress, and can end the run
 *
 * \returns what the overload with named parameters returns; the same is thrown, too
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Traits,
          typename Domain,
          typename Visitor = Default_curve_flow_visitor>
Untangling_result untangle(Curve_network_3<Traits>& curves,
                           const Domain& domain,
                           const Untangling_parameters& parameters,
                           Visitor visitor = Visitor())
{
  const auto& inside = internal::as_domain<Traits>(domain, CGAL::parameters::default_values());
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  const internal::Place_in_domain<Traits, std::decay_t<decltype(inside)>, ConcurrencyTag> place{
      inside};
  return internal::Untangling_run(curves, place, parameters, internal::unwrapped(visitor))();
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_UNTANGLE_IN_DOMAIN_H
