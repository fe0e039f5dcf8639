// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_UNTANGLE_H
#define CGAL_VOLUME_FILLING_CURVES_UNTANGLE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Polylines_in_place.h>
#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/signatures.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Strategic_untangler.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Untangling_run.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Default_curve_flow_visitor.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles curves: moves them, without ever passing through themselves, to a short and
 * simple shape.
 *
 * With the strategy `AUTO` (default) a random search brings the curves to polygons with as few
 * edges as it finds, for at most a quarter of the time limit, and then they flow, as `Curve_flow_3`
 * moves them, from there or, if that is as simple, from where they were, until they are tight, or
 * are proved to be unknots, of which a single one becomes round. With `lower_ropelength` closed
 * curves that are tight are pulled on. If closed curves were tighter before, and no thickness is
 * given, they are the result. With `FLOW` they do nothing but flow, until they are proved to be
 * unknots, are tight, or get nowhere. With `SEARCH` they stay the polygons that the search ends
 * with: of at most 5 edges per component if they are unknots, and else as short of edges as the
 * search got. Every change is certified with exact predicates, hence the result is ambient isotopic
 * to the input, whatever the status that is returned. Nodes are removed and inserted on the way;
 * `Curve_network_3::origin()` tells which node of the input a node was. Components keep their order
 * and orientation; pinned nodes stay where they are.
 *
 * A component with ends keeps its knot if all of its ends are pinned: no strand slips off them. The
 * type of an open knot is that of its closure by straight lines from the ends away from the mean of
 * all nodes, and these lines are part of the curve while it flows, as pinned nodes whose `origin()`
 * is null; a visitor sees them. `Untangling_result::is_closure_kept` tells whether the closure of
 * the result, whose mean is another, has that type as well: always where the run has converged. A
 * component with a free end has no knot to be kept.
 *
 * As long as curves get shorter fast, their edges are half a thickness long at least, and steps are
 * 2.5 times as long as `max_displacement`; visitors see that. Curves that are nearly tight from the
 * start, and results, have edges as `spacing` asks for.
 *
 * The result does not depend on the number of threads. An iteration takes near-linear time; tangled
 * knots of a thousand nodes take about 70 iterations and 0.04 seconds (236 knots).
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param np \vfcNamedParams{Untangle_signature}
 *
 * \returns how the run ended, what is proved of the curves, and statistics
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded, if a coordinate is beyond 1e150 or
 * the size below 1e-150, if a pinned end is shut in such that no straight line leads from it to the
 * outside, or a node is pinned although the length is to be kept, with the nodes in the message;
 * and if a parameter has a value that it must not have, with its name in the message.
 * \throws Run_state_error if the state to resume from is that of another run, with what differs in
 * the message
 *
 * The curves are unchanged then. What a visitor throws is passed on.
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Are_named_parameters<NamedParameters>::value, int> = 0
#endif
          >
Untangling_result untangle(Curve_network_3<Traits>& curves,
                           const NamedParameters& np = parameters::default_values())
{
  return untangle<ConcurrencyTag>(curves,
                                  internal::get_parameters<internal::Untangle_signature>(np),
                                  internal::get_visitor(np));
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles a polyline, or several.
 *
 * By \cgal's habit a polyline is closed if its last point repeats the first, and so is then that of
 * the result; the ends of the others are pinned. See the overload for `Curve_network_3`.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Polylines a model of `SequenceContainer` whose items are points, or such containers
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines, replaced by the result
 * \param np \vfcNamedParams{Untangle_polylines_signature}
 *
 * \returns how the run ended, what is proved of the curves, and statistics
 *
 * \throws std::invalid_argument as that overload and that constructor. The polylines are unchanged
 * then.
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Polylines,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::is_range_of_items<Polylines>, int> = 0
#endif
          >
Untangling_result untangle(Polylines& polylines,
                           const NamedParameters& np = parameters::default_values())
{
  const auto parameters = internal::get_parameters<internal::Untangle_polylines_signature>(np);
  internal::Polylines_in_place<Polylines, NamedParameters> in_place(polylines, np);
  const Untangling_result result =
      untangle<ConcurrencyTag>(in_place.curves(), parameters, internal::get_visitor(np));
  in_place.store();
  return result;
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles curves, with a struct of parameters in place of named ones.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Visitor a model of `CurveFlowVisitor`, or a `std::reference_wrapper` of one
 *
 * \param curves the curves, replaced by the result
 * \param parameters the parameters
 * \param visitor is told of the progress, and can end the run
 *
 * \returns what the overload with named parameters returns; the same is thrown, too
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Traits,
          typename Visitor = Default_curve_flow_visitor>
Untangling_result untangle(Curve_network_3<Traits>& curves,
                           const Untangling_parameters& parameters,
                           Visitor visitor = Visitor())
{
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  const internal::Whole_space<Traits, ConcurrencyTag> space;
  return internal::Untangling_run(curves, space, parameters, internal::unwrapped(visitor))();
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns a copy of the curve that a visitor of `untangle()` sees, without the rays that it
 * has at pinned ends while it flows (see `CurveFlowVisitor`); a plain copy if there are none.
 *
 * Linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 *
 * \pre the network has no garbage
 */
template <typename Traits>
[[nodiscard]] Curve_network_3<Traits> without_closing_rays(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  Curve_network_3<Traits> copy(curve);
  Isotopy_guard_3<Traits>(copy).remove_rays();
  return copy;
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_UNTANGLE_H
