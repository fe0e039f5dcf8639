// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_FILL_H
#define CGAL_VOLUME_FILLING_CURVES_FILL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Polylines_in_place.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_call.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_tree.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/signatures.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/check_concepts.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Default_curve_flow_visitor.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Finger_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <stdexcept>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {

template <typename ConcurrencyTag, typename Traits, typename MakeDomain, typename Visitor>
auto fill(Curve_network_3<Traits>& curves,
          const MakeDomain& make_domain,
          const Filling_parameters<typename Traits::Point_3>& parameters,
          Visitor& visitor)
{
  using Domain = std::decay_t<decltype(make_domain())>;
  static_assert(check_visitor<Visitor, Curve_flow_3<Traits, Domain, ConcurrencyTag>>());
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  return Filling_call<Traits, ConcurrencyTag, Visitor>(curves, parameters, visitor)(make_domain);
}

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief fills a domain evenly with curves: lets them grow until nearly every point inside is
 * within about 1.4 times the thickness r of them.
 *
 * The curves never leave the domain and never pass through themselves or one another: every change
 * is certified (see `Isotopy_guard_3`), so that the result is ambient isotopic to the start and
 * lies strictly inside, as exactly as the domain can tell. Components that are not connected grow
 * side by side; networks keep their graph, pinned nodes their places.
 *
 * If there are no curves yet, a small circle is placed at the widest place of each connected part
 * of the inside that is wide enough, that is, holds a ball with an eighth of the radius r, or of
 * that of the widest ball inside. From the curves fingers reach out all over the domain, which then
 * open (see `Filling_start`). A mesh knows its parts by its shells. In any other domain parts are
 * found by samples: one with a passage that is thinner than the samples are dense may count as two.
 * Where more than 1 % of the domain is too thin for r, the visitor's `on_thin_domain()` is called
 * before the start.
 *
 * With `Wall::COVER` the curve settles at about r from the boundary, with `Wall::KEEP_CLEAR` at
 * about 2r, and in both cases strands settle at about 2r from one another. On nine domains 79 to 80
 * % of the volume ended within r and 99 % within 1.4 r. A user who asks that every
 * point is within some distance of the curve gives a thickness smaller by about 1.4.
 *
 * The run ends when the curve has settled at the thickness asked for, and every empty region has
 * been driven at. A curve that has settled has not always filled its domain: if more than 1 % of
 * the volume is farther than 2 r from it, the status is `Filling_status::PARTIAL`, and
 * `Filling_result::reason` says why. For the curve to settle the steps shrink in the end, by a
 * fifth each: otherwise it trembles for good. Until the last steps edges are up to half as long
 * again as asked for, which saves time.
 *
 * The time limit also holds for the survey of the domain, where fewer samples are taken then, and
 * for the measures of the result, which are left out. A step that would end after it is not begun,
 * and one that does is broken off, unless there is a `checkpoint`: states are taken between steps.
 *
 * A domain multiplied by a power of two, with its lengths, gives the same curve, multiplied
 * likewise, in every bit. A domain larger than 1e38 or smaller than 1e-38 must be a model of
 * `ScalableVolumeFillingDomain_3` for that, as all domains of this package are. A visitor then sees
 * all that can be read of a `Curve_flow_3`, but not the object itself.
 *
 * The result is the same for every number of threads. The time is near-linear in the volume divided
 * by the cube of r for a given shape.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded, or a model
 * of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param domain the domain, or a closed triangle mesh, whose inside is filled as a
 * `Triangle_mesh_domain_3` is
 * \param np \vfcNamedParams{Fill_mesh_signature}
 *
 * \returns how the run ended, where the curve did not get to, and statistics
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded or not strictly inside the domain,
 * with the nodes in the message, if the domain is unbounded, larger than 1e150 or smaller than
 * 1e-150, or without `scaled()` beyond 1e38 or below 1e-38, hardly any point of its box is inside,
 * or its answers contradict each other, if a parameter has a value that it must not have, with its
 * name in the message and, of a field, the point, if both a length and a thickness are given, or if
 * a mesh bounds no domain, see `Triangle_mesh_domain_3`
 * It is also thrown if the curve would have more than 20 million nodes, which take some 30 GB, or
 * with the thickness by default 2 million.
 * \throws Run_state_error if the state to resume from is that of another run, with what differs in
 * the message
 *
 * What a visitor, a field or the domain throws is passed on.
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Traits,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Filling_result<typename Traits::Point_3> fill(
    Curve_network_3<Traits>& curves,
    const Domain& domain,
    const NamedParameters& np = parameters::default_values())
{
  using Point_3 = typename Traits::Point_3;
  using Signature =
      std::conditional_t<internal::Is_domain<Domain>::value, internal::Fill_signature<Point_3>,
                         internal::Fill_mesh_signature<Point_3>>;
  const auto parameters = internal::get_parameters<Signature>(np);
  auto visitor = internal::get_visitor(np);
  return internal::fill<ConcurrencyTag>(
      curves, [&]() -> decltype(auto) { return internal::as_domain<Traits>(domain, np); },
      parameters, internal::unwrapped(visitor));
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief fills a domain evenly with a polyline, or with several.
 *
 * By \cgal's habit a polyline is closed if its last point repeats the first, and so is then that of
 * the result; the ends of the others are pinned: they are ports. An empty polyline, or container,
 * stands for no curves. See the overload for `Curve_network_3`.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Polylines a model of `SequenceContainer` whose items are points, or such containers
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded, or a model
 * of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines, replaced by the result
 * \param domain the domain, or a closed triangle mesh, whose inside is filled
 * \param np \vfcNamedParams{Fill_mesh_with_polylines_signature}
 *
 * \returns how the run ended, where the curve did not get to, and statistics
 *
 * \throws std::invalid_argument as that overload and that constructor, and if an empty polyline is
 * to hold the curves of several parts of the domain. The polylines are unchanged then.
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Polylines,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::is_range_of_items<Polylines>, int> = 0
#endif
          >
auto fill(Polylines& polylines,
          const Domain& domain,
          const NamedParameters& np = parameters::default_values())
{
  internal::Polylines_in_place<Polylines, NamedParameters> in_place(polylines, np);
  using Traits = typename decltype(in_place)::Network::Traits;
  using Point_3 = typename Traits::Point_3;
  using Signature = std::conditional_t<internal::Is_domain<Domain>::value,
                                       internal::Fill_polylines_signature<Point_3>,
                                       internal::Fill_mesh_with_polylines_signature<Point_3>>;
  const auto parameters = internal::get_parameters<Signature>(np);
  auto visitor = internal::get_visitor(np);
  const Filling_result<Point_3> result = internal::fill<ConcurrencyTag>(
      in_place.curves(),
      [&]() -> decltype(auto) { return internal::as_domain<Traits>(domain, np); }, parameters,
      internal::unwrapped(visitor));
  in_place.store();
  return result;
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief fills a domain, with a struct of parameters in place of named ones.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded, or a model
 * of `FaceListGraph`
 * \tparam Point_3 that point type
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
          typename Point_3,
          typename Visitor = Default_curve_flow_visitor>
Filling_result<Point_3> fill(Curve_network_3<Traits>& curves,
                             const Domain& domain,
                             const Filling_parameters<Point_3>& parameters,
                             Visitor visitor = Visitor())
{
  return internal::fill<ConcurrencyTag>(
      curves,
      [&]() -> decltype(auto) {
        return internal::as_domain<Traits>(domain, CGAL::parameters::default_values());
      },
      parameters, internal::unwrapped(visitor));
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// What `grow_fingers()` returns.
struct Finger_growth
{
  std::size_t number_of_places = 0;  ///< well-spaced points that were to be reached
  std::size_t number_of_fingers = 0; ///< of those, how many were
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief lets curves reach out all over a domain: the start of `fill()`, for those who go on in
 * their own way.
 *
 * Points that are 2.9 r apart are scattered in the domain, at least r/2 from its boundary, or r/8
 * where it is narrow. Along a random spanning tree of them, which begins at the curves, fingers
 * grow: an edge of the curve is halved, and one half is pulled out to the next point, with a blunt
 * tip that is 1.4 r wide. These are three insertions of nodes that the guard certifies, so that the
 * result is ambient isotopic to what it was: the outline of a tree, in place of a small circle. To
 * points that no straight finger gets to, ways with room for a ball of radius r/14 are searched,
 * and thin fingers are led along them, through necks and around corners. The time is near linear in
 * the number of points.
 *
 * Of several components the one that has got least of the volume grows first, so that they share
 * it. Pinned nodes stay where they are; networks keep their graph. The curves are numbered again.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param guard the guard of the curves, in their domain
 * \param np \vfcNamedParams{Finger_signature}
 *
 * \returns how many points there are, and how many of them were reached
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if a parameter has a value that it must not have, if there is no
 * thickness, or if a field has such a value somewhere, with its name and the point in the message
 *
 * What a field or the domain throws is passed on.
 */
template <typename Traits,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Finger_growth grow_fingers(Isotopy_guard_3<Traits, Domain>& guard,
                           const NamedParameters& np = parameters::default_values())
{
  using Point_3 = typename Traits::Point_3;
  CGAL_precondition_msg(!guard.curve().has_garbage(), "the network has no garbage");
  const auto parameters = internal::get_parameters<internal::Finger_signature<Point_3>>(np);
  internal::check_parameters(parameters);
  const internal::Thickness<Point_3> thickness(parameters.thickness, parameters.thickness_field);
  if(!thickness.is_given())
    throw std::invalid_argument("thickness: there is none, and fingers have no default");
  internal::Run_watch watch(parameters.time_limit, parameters.progress);
  watch.begin(Run_stage::BRANCHING);
  internal::Finger_tree tree(guard, guard.boundary().domain(), thickness, parameters.random_seed,
                             watch);
  tree.follow(parameters.direction_field, parameters.direction_weight);
  tree.grow();
  return {tree.number_of_places(), tree.number_of_fingers()};
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_FILL_H
