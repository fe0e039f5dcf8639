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
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/domain/Any_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Inset_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_call.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_stations.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_tree.h>
#include <CGAL/Volume_filling_curves/internal/guard/Garbage_scope.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/signatures.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/check_concepts.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Default_curve_flow_visitor.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <stdexcept>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {

// Returns the domain itself, or the domain that a polygon or a mesh bounds.
template <typename Traits, typename Domain, typename NamedParameters>
decltype(auto) as_filled_domain(const Domain& domain, const NamedParameters& np)
{
  if constexpr(Is_polygonal<Domain>::value)
    return Polygon_domain_3<Traits>(domain);
  else
    return as_domain<Traits>(domain, np);
}

// Whether a domain is a mesh, which has its own named parameters.
template <typename Domain>
constexpr bool is_mesh = !Is_domain<Domain>::value && !Is_polygonal<Domain>::value;

template <typename ConcurrencyTag, typename Traits, typename MakeDomain, typename Visitor>
auto fill(Curve_network_3<Traits>& curves,
          const MakeDomain& make_domain,
          const Filling_parameters<typename Traits::Point_3>& parameters,
          Visitor& visitor)
{
  using Domain = std::decay_t<decltype(any_domain(make_domain()))>;
  static_assert(check_visitor<Visitor, Curve_flow_3<Traits, Domain, ConcurrencyTag>>());
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  return Filling_call<Traits, ConcurrencyTag, Visitor>(curves, parameters, visitor)(make_domain);
}

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief fills a domain evenly with curves: grows them until about nine tenths of the volume is
 * within the thickness r of them, and nearly all of it within 1.4 r.
 *
 * The curves never leave the domain and never pass through themselves or one another. Every change
 * is certified (see `Isotopy_guard_3`): the result is ambient isotopic to the start and lies
 * strictly inside, which is as reliable as the answers of the domain. Components of a curve grow
 * side by side; networks keep their graph, pinned nodes stay where they are, and sliding nodes stay
 * on their sets (see `Node_constraint`). A component all of whose nodes slide grows without
 * fingers, which would leave these sets; it needs `Filling_start::CIRCLE`.
 *
 * If neither curves nor ports are given, a small circle is placed at the widest point of each
 * connected part of the inside that is wide enough. A part is wide enough if it holds a ball whose
 * radius is an eighth of r, or an eighth of the radius of the widest ball inside if that is less; a
 * `wall_distance` reduces the radii of both balls.
 * Fingers then grow from the curves through the whole domain, and open (see `Filling_start`).
 * Meshes, polygons and models of `VolumeFillingDomainWithSurface_3` define their parts themselves,
 * a mesh by its shells. In other domains parts are found from samples, and a part with a passage
 * narrower than the distance between samples may count as two. If more than 1 % of the domain is
 * too thin for r, the visitor's `on_thin_domain()` is called first.
 *
 * The curve settles at about r from the boundary with `Wall::COVER` and at about 2 r with
 * `Wall::KEEP_CLEAR`. On nine domains, with `Wall::COVER`, 90 to 95 % of the volume lies within r
 * of the curve, and 99 % within 1.1 r to 1.4 r. If nearly every point must lie within d of the
 * curve, use r = d / 1.4. If the status is `Filling_status::CONVERGED` or
 * `Filling_status::PARTIAL`, strands are at least 1.6 r apart. Without `round_bends` they can be
 * closer, and about 80 % of the volume is within r. The result has the least distances, the
 * tightest bend, and the share of the length along which another strand is nearer than r. With
 * ports, the least distance from the boundary is that of their necks.
 *
 * In a planar domain, such as a polygon with holes, the curve lies exactly in the plane z = 0, and
 * areas replace volumes; 97 to 99 % of a plate lies within r of the curve, and 99 % within 1.15 r.
 *
 * The run ends when the curve has settled within the limits of its shape. Without `round_bends` it
 * has also been pushed into every empty region. With `round_bends`, spikes and gaps that are too
 * narrow for a bend stay empty. A settled curve need not fill its domain: if more than 1 % of the
 * volume is farther than 2 r from it, or another strand nearer than r along more than 5 % of its
 * length, the status is `Filling_status::PARTIAL`, unless the length or a limit of the shape is
 * missed; `Filling_result::reason` states the cause. Towards the end each step is an eighth
 * to a fifth shorter than the one before; otherwise the curve keeps oscillating.
 *
 * The time limit includes the survey of the domain, which takes fewer samples if time is short.
 * After a stop, a tenth of a second is left to measure the result; measures that are not complete
 * by then are skipped. A step that is expected to end after the limit is not started, and a step
 * that overruns it is abandoned, unless there is a `checkpoint`: states are saved between steps.
 *
 * Scaling a domain and its lengths by a power of two scales the curve by the same factor, bit for
 * bit. Beyond 1e38 and below 1e-38 this requires a model of `ScalableVolumeFillingDomain_3`, as all
 * domains of this package are. A visitor then receives an object with the reading functions of
 * `Curve_flow_3` instead of the flow itself.
 *
 * The result does not depend on the number of threads. For a given shape, the time is near-linear
 * in the volume divided by r cubed.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a bounded model of `VolumeFillingDomain_3` with the same point type, a model of
 * `FaceListGraph`, a `CGAL::Polygon_2`, a `CGAL::Polygon_with_holes_2`, or a range of polygons with
 * holes
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param domain the domain, a closed triangle mesh, which stands for the `Triangle_mesh_domain_3`
 * that it bounds, or polygons, which stand for their `Polygon_domain_3`
 * \param np \vfcNamedParams{Fill_mesh_signature}
 *
 * \returns how the run ended, which regions the curve did not reach, and statistics
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if
 * - the curves are not embedded or not strictly inside the domain (the message lists the nodes);
 * - fingers are to grow, and all nodes of a component slide or are pinned (the message names the
 *   component and its first node);
 * - the domain is unbounded, larger than 1e150 or smaller than 1e-150, or has no `scaled()` beyond
 *   1e38 or below 1e-38;
 * - hardly any point of the domain's box is inside, or the domain's answers contradict each other;
 * - a mesh or a polygon bounds no domain, see `Triangle_mesh_domain_3` and `Polygon_domain_3`;
 * - a parameter is out of its range (the message names it and, for a field, the point);
 * - the thickness, `bend_radius` or `strand_distance` is larger than the diagonal of the domain's
 *   box;
 * - `wall_distance` is too large: a given curve comes as near to the boundary, a node is to slide
 *   nearer to it, or no point inside is farther away;
 * - both a length and a thickness are given;
 * - ports do not fit: their number is odd, curves are given as well, one of them is not at the
 *   boundary or has no room for its neck, or no path joins two of them;
 * - the number of `volume_shares` is not that of components, or there are neither curves nor ports;
 * - the curve would have more than 20 million nodes, which take some 30 GB, or more than 2 million
 *   with the default thickness
 *
 * \throws Run_state_error (an `std::invalid_argument`) if `resume_from` is damaged or belongs to a
 * different run
 *
 * If one of these is thrown, the curves are unchanged. Exceptions of the visitor, of a field and of
 * the domain pass through.
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
      std::conditional_t<internal::is_mesh<Domain>, internal::Fill_mesh_signature<Point_3>,
                         internal::Fill_signature<Point_3>>;
  const auto parameters = internal::get_parameters<Signature>(np);
  auto visitor = internal::get_visitor(np);
  return internal::fill<ConcurrencyTag>(
      curves, [&]() -> decltype(auto) { return internal::as_filled_domain<Traits>(domain, np); },
      parameters, internal::unwrapped(visitor));
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief fills a domain evenly with one or more polylines.
 *
 * As usual in \cgal, a polyline is closed if its last point repeats the first; its result is then
 * closed in the same way. The ends of all other polylines are pinned, and serve as ports. An empty
 * polyline or container means that no curves are given. See the overload for `Curve_network_3`.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Polylines a model of `SequenceContainer` with `push_back()`. Its items are default
 * constructible: points, objects whose points `point_map` reads and writes, or such containers
 * \tparam Domain a bounded model of `VolumeFillingDomain_3` with the same point type, a model of
 * `FaceListGraph`, a `CGAL::Polygon_2`, a `CGAL::Polygon_with_holes_2`, or a range of polygons with
 * holes
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines, replaced by the result
 * \param domain the domain, or a closed triangle mesh or polygons that bound it
 * \param np \vfcNamedParams{Fill_mesh_with_polylines_signature}
 *
 * \returns how the run ended, which regions the curve did not reach, and statistics
 *
 * \throws std::invalid_argument like that overload and the constructor of `Curve_network_3` from
 * polylines, and if a single empty polyline is given for a domain with several parts. After an
 * exception the polylines are unchanged.
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
  using Signature = std::conditional_t<internal::is_mesh<Domain>,
                                       internal::Fill_mesh_with_polylines_signature<Point_3>,
                                       internal::Fill_polylines_signature<Point_3>>;
  const auto parameters = internal::get_parameters<Signature>(np);
  auto visitor = internal::get_visitor(np);
  const Filling_result<Point_3> result = internal::fill<ConcurrencyTag>(
      in_place.curves(),
      [&]() -> decltype(auto) { return internal::as_filled_domain<Traits>(domain, np); },
      parameters, internal::unwrapped(visitor));
  in_place.store();
  return result;
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief fills a domain; the parameters come as a struct.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a bounded model of `VolumeFillingDomain_3` with the same point type, a model of
 * `FaceListGraph`, a `CGAL::Polygon_2`, a `CGAL::Polygon_with_holes_2`, or a range of polygons with
 * holes
 * \tparam Point_3 the point type of the domain
 * \tparam Visitor a model of `CurveFlowVisitor`, or a `std::reference_wrapper` of one
 *
 * \param curves the curves, replaced by the result
 * \param domain the domain, or a closed triangle mesh or polygons that bound it
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
        return internal::as_filled_domain<Traits>(domain, CGAL::parameters::default_values());
      },
      parameters, internal::unwrapped(visitor));
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The result of `grow_fingers()`.
struct Finger_growth
{
  std::size_t number_of_points = 0;  ///< well-spaced points to reach
  std::size_t number_of_fingers = 0; ///< points that a finger reached
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief grows fingers from curves through a whole domain. This is the first stage of `fill()`, as
 * a building block for other fillings.
 *
 * Points about 2.9 r apart (4 r in the plane, a tenth less along a field) are scattered in the
 * domain, at least r/2 from its boundary, or r/8 in narrow regions. Fingers grow along a random
 * spanning tree of these points, which starts at the curves: an edge of the curve is halved, and
 * one half is pulled out to the next point, with a blunt tip at most 1.4 r wide. Each finger
 * consists of three insertions of nodes, which the guard certifies; so the result is ambient
 * isotopic to the input. A small circle thereby becomes the outline of a tree. To points that no
 * straight finger reaches, a path search finds paths with clearance r/14, and thin fingers follow
 * them through necks and around corners. In a box, 13,000 points take 0.5 s, and 102,000 take 7 s.
 *
 * If there are several components, the one with the smallest share of the volume grows next, which
 * divides the domain evenly. Pinned and sliding nodes stay where they are, and no finger grows from
 * an edge on which inserted nodes would slide; networks keep their graph. The nodes are renumbered.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param guard the guard of the curves, in their domain
 * \param np \vfcNamedParams{Finger_signature}
 *
 * \returns the number of points, and the number of points that were reached
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if a parameter is out of its range, if no thickness is given, if it
 * is too small for the curves or the domain, or if a field is out of its range at a point (the
 * message names the parameter and the point); or if inserted nodes would slide all over a component
 *
 * Exceptions of a field and of the domain pass through.
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
  internal::check_sliding(guard.curve());
  const double length =
      internal::length_in_units(guard.curve(), thickness.at_each(guard.curve().points()));
  if(internal::has_too_many_nodes(length, 1, 1))
    throw std::invalid_argument("thickness: the curves would have more than 20 million nodes");
  const internal::Garbage_scope scope(guard);
  internal::Run_watch watch(parameters.time_limit, parameters.progress);
  watch.begin(Run_stage::BRANCHING);
  internal::Finger_tree tree(guard, guard.boundary().domain(), thickness, parameters.random_seed,
                             watch);
  tree.follow(parameters.direction_field, parameters.direction_weight);
  tree.grow();
  return {tree.number_of_targets(), tree.number_of_fingers()};
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_FILL_H
