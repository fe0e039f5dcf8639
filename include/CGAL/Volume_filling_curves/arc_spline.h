// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_ARC_SPLINE_H
#define CGAL_VOLUME_FILLING_CURVES_ARC_SPLINE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/arcs/Arc_certifier.h>
#include <CGAL/Volume_filling_curves/internal/arcs/Arc_spline.h>
#include <CGAL/Volume_filling_curves/internal/arcs/Arc_spline_builder.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/domain/containment.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/check_concepts.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/assertions.h>

#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief rounds the corners of a curve inside a domain: returns a smooth curve of circular arcs and
 * segments, certified if possible.
 *
 * Each corner is replaced by the arc that is tangent to both of its edges and touches the shorter
 * one in its middle; segments join the arcs. The direction of the curve is continuous, and the
 * radius is nowhere less than `min_bend_radius()`. Straight corners and ends stay. The direction
 * jumps only at junctions, where paths end.
 *
 * The spline is certified if it is ambient isotopic to the curve and strictly inside the domain.
 * This holds if the closed triangles of the arcs' ends and corners lie inside, and meet one another
 * and the rest of the curve only in common ends. Exact predicates decide this, with the answers
 * of the domain, for the returned points `start`, `corner` and `end`, and curves in the triangles
 * between them: the arcs are rational quadratic Bezier curves with the weights 1,
 * \f$\cos(\theta/2)\f$, 1 at a corner with the turning angle \f$\theta\f$. Points on the arcs, such
 * as `middle`, are rounded.
 *
 * Strands farther apart than the longest edge are never in conflict. `Arc_spline::conflicts` lists
 * conflicting nodes; shorter edges there help, at the cost of smaller radii.
 *
 * Takes near-linear time for evenly spaced nodes.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curve the curve
 * \param domain the domain
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \returns the spline, certified or not
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curve is not embedded or not strictly inside the domain (the
 * message lists the nodes), or if its size is below 1e-150
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!internal::Are_named_parameters<Domain>::value, int> = 0
#endif
          >
[[nodiscard]] Arc_spline<typename Traits::Point_3> arc_spline(
    const Curve_network_3<Traits>& curve,
    const Domain& domain,
    const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::check_domain<Domain, typename Traits::Point_3>());
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    const internal::Watched_scope scope(watch);
    internal::check_embedded(curve);
    if constexpr(!std::is_same_v<Domain, Unbounded_domain_3<Traits>>)
      internal::check_inside(curve, domain);
    auto spline = internal::Arc_spline_builder<Curve_network_3<Traits>>(curve)();
    internal::Arc_certifier<Traits, Domain>(curve, domain, *watch)(spline);
    return spline;
  });
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief rounds the corners of a curve, like the overload for a curve inside a domain.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curve the curve
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \returns the spline, certified or not
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curve is not embedded (the message lists the nodes), or if
 * its size is below 1e-150
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Are_named_parameters<NamedParameters>::value, int> = 0
#endif
          >
[[nodiscard]] Arc_spline<typename Traits::Point_3> arc_spline(
    const Curve_network_3<Traits>& curve, const NamedParameters& np = parameters::default_values())
{
  return arc_spline(curve, Unbounded_domain_3<Traits>(), np);
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_ARC_SPLINE_H
