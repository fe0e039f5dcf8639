// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_UNTANGLE_IN_DOMAIN_H
#define CGAL_VOLUME_FILLING_CURVES_UNTANGLE_IN_DOMAIN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Any_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/containment.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_untangler.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_run.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {

// The inside of a domain as the surroundings of an Untangling_run: the curves flow, without closing
// rays.
template <typename Traits, typename Domain, typename ConcurrencyTag>
struct Domain_surroundings
{
  using Guard = Isotopy_guard_3<Traits, Domain>;
  using Network = typename Guard::Curve_network;
  using Flow = Curve_flow_3<Traits, Domain, ConcurrencyTag>;

  void check(const Network& curves, const Untangling_parameters& parameters) const
  {
    if(parameters.strategy == Untangling_strategy::SEARCH)
      refuse_value(internal_np::strategy_t(), parameters.strategy,
                   "must be flow or auto in a domain");
    check_inside(curves, domain);
  }

  Guard guard(Network& curves) const { return Guard(curves, domain); }

  void add_rays(Closing_rays<Guard>&, Untangling_parameters&) const {}

  Untangling_result untangle(const Untangling_context<Flow>& run) const
  {
    return untangle_by_flow(run, {run.parameters.thickness, 0, false, false});
  }

  const Domain& domain;
};

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles curves inside a domain: moves them to a short and simple shape, and never
 * through themselves or the boundary.
 *
 * The curves flow as with the strategy `FLOW` of `untangle()` without a domain, until they are
 * proved to be unknots, are tight, or stop making progress. The boundary limits the medial spheres
 * and the motion. Obstacles are cavities of the domain. Proofs concern the curves in space and
 * ignore the obstacles: a curve that is an unknot may still be hooked around one. With
 * `stop_at_proof(false)` it flows on until it is tight around the obstacle. Curves with ends do not
 * keep their knots, even if the ends are pinned: strands may slip off.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded, or a model
 * of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param domain the domain, or a closed triangle mesh, which stands for the
 * `Triangle_mesh_domain_3` that it bounds
 * \param np \vfcNamedParams{Untangle_in_mesh_signature}. The `strategy` must not be `SEARCH`;
 * `AUTO` stands for `FLOW`. `lower_ropelength` has no effect.
 *
 * \returns how the run ended, which proofs were found, and statistics
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument like `untangle()` without a domain; if the domain is unbounded, or
 * a mesh bounds none, see `Triangle_mesh_domain_3`; if the curves are not strictly inside (the
 * message lists the nodes); and if the `strategy` is `SEARCH`
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
 * \brief untangles one or more polylines inside a domain.
 *
 * As usual in \cgal, a polyline is closed if its last point repeats the first; its result is then
 * closed in the same way. The ends of all other polylines are pinned. See the overload for
 * `Curve_network_3`.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Polylines a model of `SequenceContainer` with `push_back()`. Its items are default
 * constructible: points, objects whose points `point_map` reads and writes, or such containers
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded, or a model
 * of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines, replaced by the result
 * \param domain the domain, or a closed triangle mesh, which bounds it
 * \param np \vfcNamedParams{Untangle_polylines_in_mesh_signature}
 *
 * \returns how the run ended, which proofs were found, and statistics
 *
 * \throws std::invalid_argument like that overload and the constructor of `Curve_network_3` from
 * polylines. After an exception the polylines are unchanged.
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
 * \brief untangles curves inside a domain; the parameters come as a struct.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded, or a model
 * of `FaceListGraph`
 * \tparam Visitor a model of `CurveFlowVisitor`, or a `std::reference_wrapper` of one
 *
 * \param curves the curves, replaced by the result
 * \param domain the domain, or a closed triangle mesh, which bounds it
 * \param parameters the parameters
 * \param visitor receives the progress of the run, and can end it
 *
 * \pre the network has no garbage
 *
 * \returns the same as the overload with named parameters, and throws the same exceptions
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
  const auto& any = internal::any_domain(inside);
  const internal::Domain_surroundings<Traits, std::decay_t<decltype(any)>, ConcurrencyTag>
      surroundings{any};
  return internal::run_untangling(curves, surroundings, parameters, internal::unwrapped(visitor));
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_UNTANGLE_IN_DOMAIN_H
