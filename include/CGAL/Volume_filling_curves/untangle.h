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
 * \brief untangles curves: moves them to a short and simple shape, and never through themselves.
 *
 * With the strategy `AUTO` (default), a random search first looks for polygons with few edges, for
 * at most a quarter of the time limit. The curves then flow, as in `Curve_flow_3`, from these
 * polygons or, if the input is as simple, from the input. The flow ends when the curves are tight
 * or are proved to be unknots; a single unknot becomes round. With `lower_ropelength`, tight closed
 * curves are then tightened further. If the closed input was tighter than the outcome, and no
 * thickness is given, the input is returned.
 *
 * With `FLOW` there is no search: the curves flow until they are proved to be unknots, are tight,
 * or stop making progress. With `SEARCH` the result is the polygon of the search: at most 5 edges
 * per component for unknots, otherwise as few edges as the search found.
 *
 * Every change is certified with exact predicates; hence the result is ambient isotopic to the
 * input, whatever the status. Nodes are inserted and removed; `Curve_network_3::origin()` returns
 * the input index of a node. Components keep their order and orientation, pinned nodes stay where
 * they are, and sliding nodes stay on their sets (see `Node_constraint`). Curves with sliding nodes
 * flow, whatever the strategy.
 *
 * A component with ends keeps its knot if all of its ends are pinned: no strand slips off them. The
 * type of an open knot is that of its closure by straight rays from the ends, which point away from
 * the mean of all nodes. While the curve flows, these closing rays are part of it, as pinned nodes
 * with a null `origin()`, and a visitor sees them. The result has a different mean;
 * `Untangling_result::is_closure_kept` states whether its own closure has the same type. It always
 * has if the run has converged. A component with a free end has no knot to keep.
 *
 * While curves shrink fast, their edges are at least half a thickness long, and steps are 2.5 times
 * as long as `max_displacement`; visitors see these curves. Results, and curves that are nearly
 * tight from the start, have the edge lengths that `spacing` requires.
 *
 * The result does not depend on the number of threads. An iteration takes near-linear time; tangled
 * knots of a thousand nodes take about 66 iterations and 0.05 seconds by the flow (236 knots).
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param np \vfcNamedParams{Untangle_signature}
 *
 * \returns how the run ended, which proofs were found, and statistics
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if
 * - the curves are not embedded (the message names the nodes), a coordinate is beyond 1e150, or the
 *   size is below 1e-150;
 * - a pinned end is enclosed: no straight ray leads from it to the outside (the message names it);
 * - a node is to slide along a boundary, and there is no domain (the message names the node);
 * - a node is pinned or slides although the length is to be kept (the message names the node);
 * - a parameter is out of its range (the message names it);
 * - the thickness, `bend_radius` or `strand_distance` is larger than the diagonal of the box of the
 *   curves;
 * - `bend_radius` or `strand_distance` is given with the strategy `SEARCH`;
 * - curves of that spacing and thickness would have more than 20 million nodes
 *
 * \throws Run_state_error (an `std::invalid_argument`) if `resume_from` is damaged or belongs to a
 * different run
 *
 * If one of these is thrown, the curves are unchanged. Exceptions of the visitor pass through.
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
 * \brief untangles one or more polylines.
 *
 * As usual in \cgal, a polyline is closed if its last point repeats the first; its result is then
 * closed in the same way. The ends of all other polylines are pinned. See the overload for
 * `Curve_network_3`.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Polylines a model of `SequenceContainer` with `push_back()`. Its items are default
 * constructible: points, objects whose points `point_map` reads and writes, or such containers
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines, replaced by the result
 * \param np \vfcNamedParams{Untangle_polylines_signature}
 *
 * \returns how the run ended, which proofs were found, and statistics
 *
 * \throws std::invalid_argument like that overload and the constructor of `Curve_network_3` from
 * polylines. After an exception the polylines are unchanged.
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
 * \brief untangles curves; the parameters come as a struct.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Visitor a model of `CurveFlowVisitor`, or a `std::reference_wrapper` of one
 *
 * \param curves the curves, replaced by the result
 * \param parameters the parameters
 * \param visitor receives the progress of the run, and can end it
 *
 * \pre the network has no garbage
 *
 * \returns the same as the overload with named parameters, and throws the same exceptions
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
  return internal::run_untangling(curves, space, parameters, internal::unwrapped(visitor));
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns a copy of a curve without the closing rays that `untangle()` adds at pinned ends
 * while the curve flows (see `CurveFlowVisitor`).
 *
 * Takes linear time.
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
