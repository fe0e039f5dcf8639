// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_UNTANGLE_H
#define CGAL_VOLUME_FILLING_CURVES_UNTANGLE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Default_curve_flow_visitor.h>
#include <CGAL/Volume_filling_curves/IO/polylines.h>
#include <CGAL/Volume_filling_curves/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/Untangling_result.h>
#include <CGAL/Volume_filling_curves/internal/Strategic_untangler.h>
#include <CGAL/Volume_filling_curves/internal/Tails.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Recording.h>
#include <CGAL/Volume_filling_curves/internal/check_embedded.h>
#include <CGAL/Volume_filling_curves/internal/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/rescale_to_length.h>
#include <CGAL/Volume_filling_curves/parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Real_timer.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles curves: moves them, without ever passing through themselves, to a short and
 * simple shape.
 *
 * With the strategy `AUTO` (default) a random search brings the curves to polygons with as few
 * edges as it finds, and then they flow, as `Curve_flow_3` moves them, until they are tight, or are
 * proved to be unknots and smooth. With `FLOW` they do nothing but flow, until they are proved to be
 * unknots, are tight, or get nowhere. With `TIGHTEN` they stay the polygons that the search ends
 * with: of at most 5 edges per component if they are unknots, and else as short of edges as the
 * search got. Every change is certified with exact predicates, hence the result is ambient isotopic
 * to the input, whatever the status that is returned. Nodes are removed and inserted on the way;
 * `Curve_network_3::origin()` tells which node of the input a node was. Components keep their order
 * and orientation; pinned nodes stay where they are.
 *
 * A component with ends keeps its knot if all of its ends are pinned: no strand slips off them. The
 * type of an open knot is that of its closure by straight lines from the ends away from the mean of
 * all nodes, and these lines are part of the curve while it flows, as pinned nodes whose `origin()`
 * is null; a visitor sees them. A component with a free end has no knot to be kept.
 *
 * The result does not depend on the number of threads. An iteration takes near-linear time; tangled
 * knots of a thousand nodes take about a hundred iterations and 0.15 seconds (236 knots, 2026-11-21).
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{strategy}
 *     \cgalParamDescription{how the curves are untangled. Open curves with pinned ends flow, whatever
 *       the strategy.}
 *     \cgalParamType{`Untangling_strategy`}
 *     \cgalParamDefault{`Untangling_strategy::AUTO`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_chains}
 *     \cgalParamDescription{the number of independent searches, of which the first that succeeds, in
 *       number of moves, is taken. They run on threads of their own if `ConcurrencyTag` allows.}
 *     \cgalParamType{an integral type}
 *     \cgalParamDefault{`2`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{random_seed}
 *     \cgalParamDescription{the seed of the searches, on which the result depends}
 *     \cgalParamType{an integral type}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{thickness}
 *     \cgalParamDescription{the distance r that strands keep from the medial surface between them, in
 *       the input's unit. A curve that is too thick jams, a thinner one is slower but gets further.}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{the 25th percentile of the medial radii of the input, or with `AUTO` of the
 *       polygon that the search ends with; a fortieth of its length if that is a proved unknot}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{tolerance}
 *     \cgalParamDescription{the curve is tight if `Curve_flow_3::gradient_norm()` is less}
 *     \cgalParamType{`double`, dimensionless}
 *     \cgalParamDefault{`0.007`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the largest number of iterations of the flow; of the sweeps of
 *       `Tightening_progress` with `Untangling_strategy::TIGHTEN`}
 *     \cgalParamType{an integral type}
 *     \cgalParamDefault{`5000`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{time_limit}
 *     \cgalParamDescription{the longest time to run, checked between iterations}
 *     \cgalParamType{`double`, in seconds}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{stop_at_proof}
 *     \cgalParamDescription{whether to stop once the curves are proved to be unknots and unlinked and
 *       are short, 8 thicknesses per component, which is at most 50 iterations later. Otherwise a
 *       single curve ends as a regular polygon of that length, of 64 nodes or more, and several
 *       flow on until they are tight, as small loops.}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{keep_length}
 *     \cgalParamDescription{whether to scale the result, by certified steps, to the length of the
 *       input. The thickness that is returned is scaled likewise.}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *     \cgalParamPrecondition{no node is pinned, hence no polyline is open}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{certificate}
 *     \cgalParamDescription{receives the record of the whole run, which `verify_certificate()`
 *       verifies; pass `std::ref()` of it. It takes some 26 bytes per node and iteration.}
 *     \cgalParamType{`Isotopy_certificate`}
 *     \cgalParamDefault{nothing is recorded}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_directions}
 *     \cgalParamDescription{the number of medial spheres per node}
 *     \cgalParamType{an integral type}
 *     \cgalParamDefault{`16`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{max_radius}
 *     \cgalParamDescription{the largest radius of a medial sphere}
 *     \cgalParamType{`double`, in units of the thickness}
 *     \cgalParamDefault{`0.9`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{spacing}
 *     \cgalParamDescription{the least length h of an edge; edges longer than 2h are split}
 *     \cgalParamType{`double`, in units of the thickness}
 *     \cgalParamDefault{`0.2`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{screening}
 *     \cgalParamDescription{the weight lambda of the mass matrix in the preconditioner}
 *     \cgalParamType{`double`, in units of 1 / thickness^2}
 *     \cgalParamDefault{`0.3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{coupling}
 *     \cgalParamDescription{the weight beta of the medial spheres in the preconditioner}
 *     \cgalParamType{`double`, dimensionless}
 *     \cgalParamDefault{`0.01`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{preconditioner}
 *     \cgalParamDescription{the preconditioner}
 *     \cgalParamType{`Preconditioner`}
 *     \cgalParamDefault{`Preconditioner::MEDIAL`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{time_step}
 *     \cgalParamDescription{the fixed time step tau of the paper instead of an adaptive step}
 *     \cgalParamType{`double`, dimensionless}
 *     \cgalParamDefault{`0`, for an adaptive step}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor that follows the progress and can stop it; pass `std::ref()` of
 *       it to keep its state}
 *     \cgalParamType{a class model of `CurveFlowVisitor`}
 *     \cgalParamDefault{`Default_curve_flow_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \returns how the run ended, what is proved of the curves, and statistics
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded, with the nodes in the message, if a
 * coordinate is beyond 1e150 or the size below 1e-150, or if a parameter is not positive and finite
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Untangling_result untangle(Curve_network_3<Traits>& curves,
                           const NamedParameters& np = parameters::default_values())
{
  using Flow = Curve_flow_3<Traits, ConcurrencyTag>;
  using Visitor_reference = typename CGAL::internal_np::Lookup_named_param_def<
      CGAL::internal_np::visitor_t, NamedParameters, Default_curve_flow_visitor>::reference;
  Default_curve_flow_visitor default_visitor;
  Visitor_reference visitor = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::visitor), default_visitor);

  Isotopy_certificate no_certificate;
  Isotopy_certificate& certificate = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter_reference(np, internal_np::certificate), no_certificate);

  const bool keeps_length = internal::parameter_or(np, internal_np::keep_length, false);
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  CGAL_precondition_msg(!keeps_length || !internal::has_pinned_node(curves), "no node is pinned");
  Real_timer timer;
  timer.start();
  internal::check_embedded(curves);
  const double length = internal::length(curves);
  const bool is_recorded = &certificate != &no_certificate;
  const internal::Recording<Traits> recording(curves, is_recorded);
  Curve_flow_parameters flow_parameters = internal::get_flow_parameters(np);
  Untangling_result result;
  {
    internal::Tails<Curve_network_3<Traits>> tails(curves);
    tails.template grow<ConcurrencyTag>(flow_parameters);
    internal::Strategic_untangler<Flow, ConcurrencyTag, std::remove_reference_t<Visitor_reference>>
        run(curves, tails, internal::get_strategy_parameters(np), flow_parameters,
            internal::get_stop_rules(np), timer, visitor);
    result = run();
  }
  if(keeps_length) result.thickness *= internal::rescale_to_length(curves, length);
  if(is_recorded) certificate = recording.certificate();
  return result;
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief untangles polylines.
 *
 * A polyline whose last point repeats its first is closed; the ends of the others are pinned.
 * See the overload for `Curve_network_3`, whose named parameters can be passed, too.
 *
 * \tparam ConcurrencyTag enables parallel algorithms
 * \tparam Point_3 the point type of a \cgal kernel with exact predicates
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines, replaced by the result
 * \param np an optional sequence of named parameters
 *
 * \returns how the run ended, what is proved of the curves, and statistics
 *
 * \throws std::invalid_argument if the polylines are not embedded curves
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Point_3,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Untangling_result untangle(std::vector<std::vector<Point_3>>& polylines,
                           const NamedParameters& np = parameters::default_values())
{
  using Traits = Curve_flow_traits_3<typename Kernel_traits<Point_3>::Kernel>;
  Curve_network_3<Traits> curves;
  std::vector<Curve_defect> defects;
  if(!polylines_to_curve_network(polylines, curves, defects, Junctions::FORBIDDEN, np))
    throw std::invalid_argument(
        to_string(*std::find_if(defects.begin(), defects.end(),
                                [](const Curve_defect& d) { return is_error(d.kind); }),
                  "polylines"));
  curves.pin_ends();
  const Untangling_result result = untangle<ConcurrencyTag>(curves, np);
  polylines.clear();
  curve_network_to_polylines(curves, std::back_inserter(polylines));
  return result;
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_UNTANGLE_H
