// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_FILL_H
#define CGAL_VOLUME_FILLING_CURVES_FILL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Default_curve_flow_visitor.h>
#include <CGAL/Volume_filling_curves/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/Filler.h>
#include <CGAL/Volume_filling_curves/internal/Widest_place.h>
#include <CGAL/Volume_filling_curves/internal/check_embedded.h>
#include <CGAL/Volume_filling_curves/internal/check_inside.h>
#include <CGAL/Volume_filling_curves/internal/filling_task.h>
#include <CGAL/Volume_filling_curves/parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief fills a domain evenly with curves: lets them grow until nearly every point inside is within
 * the thickness r of them.
 *
 * The curves never leave the domain and never pass through themselves or one another: every change is
 * certified (see `Isotopy_guard_3`), so that the result is ambient isotopic to the start and lies
 * strictly inside, as exactly as the domain can tell. Components that are not connected grow side by
 * side; networks keep their graph, pinned nodes their places.
 *
 * If there are no curves yet, a circle is placed where the domain is widest.
 *
 * With `Wall::COVER` the curve settles at about r from the boundary, with `Wall::KEEP_CLEAR` at about
 * 2r, and in both cases strands settle at about 2r from one another. On nine domains 77 to 79 % of the
 * volume ended within r and 99 % within 1.4 r (2026-11-21). A user who asks that every point is within
 * some distance of the curve gives a thickness smaller by about 1.4.
 *
 * The run ends when the length settles at the thickness asked for, and every empty region has been driven
 * at. For the length to settle the steps shrink in the end, by 3 % each: otherwise the curve trembles for
 * good.
 *
 * The result is the same for every number of threads. The time is near-linear in the volume divided
 * by the cube of r for a given shape.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param domain the domain
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{thickness}
 *     \cgalParamDescription{the thickness r: half the distance of neighboring strands. A function makes
 *       it vary in space; it must be positive and safe to call concurrently.}
 *     \cgalParamType{`double`, in the input's unit, or a functor with
 *       `double operator()(const Point_3&) const`}
 *     \cgalParamDefault{a quarter of the radius of the widest ball inside}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{length}
 *     \cgalParamDescription{the length that the result is to have, instead of a thickness, which is
 *       found within 2 %}
 *     \cgalParamType{`double`, in the input's unit}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{wall}
 *     \cgalParamDescription{what the boundary is to the medial spheres}
 *     \cgalParamType{`Wall`}
 *     \cgalParamDefault{`Wall::COVER`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the largest number of iterations}
 *     \cgalParamType{an integral type}
 *     \cgalParamDefault{`5000`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{time_limit}
 *     \cgalParamDescription{the longest time to run, checked between iterations}
 *     \cgalParamType{`double`, in seconds}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{random_seed}
 *     \cgalParamDescription{the seed of the random samples with which the widest place and empty
 *       regions are found}
 *     \cgalParamType{an integral type}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_directions}
 *     \cgalParamDescription{the number of medial spheres per node}
 *     \cgalParamType{an integral type}
 *     \cgalParamDefault{`16`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{max_radius}
 *     \cgalParamDescription{the largest radius of a medial sphere while the curve grows: the speed of
 *       the growth. In the end it is at most 2.}
 *     \cgalParamType{`double`, in units of the thickness}
 *     \cgalParamDefault{`6`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{spacing}
 *     \cgalParamDescription{the least length h of an edge; edges longer than 2h are split}
 *     \cgalParamType{`double`, in units of the thickness}
 *     \cgalParamDefault{`0.2`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{screening}
 *     \cgalParamDescription{the weight lambda of the mass matrix in the preconditioner, the locality of
 *       the flow. While the curve grows it is 30 times larger.}
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
 * \returns how the run ended, where the curve did not get to, and statistics
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded or not strictly inside the domain, with
 * the nodes in the message, if the domain is unbounded, or if a parameter is not positive and finite
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
  using Samples = Domain_samples_3<Traits, Domain>;
  using Flow = Curve_flow_3<Traits, ConcurrencyTag, Domain>;
  using Visitor_reference = typename CGAL::internal_np::Lookup_named_param_def<
      CGAL::internal_np::visitor_t, NamedParameters, Default_curve_flow_visitor>::reference;
  Default_curve_flow_visitor default_visitor;
  Visitor_reference visitor = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::visitor), default_visitor);

  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  Real_timer timer;
  timer.start();
  const auto seed = internal::parameter_or(np, CGAL::internal_np::random_seed, std::uint64_t(0));
  const Samples samples(domain, Samples::default_number, seed, curves.traits());
  const internal::Widest_place<Domain, Traits> widest(domain, samples.points(), curves.traits());
  if(curves.number_of_nodes() == 0) curves = widest.template circle<Curve_network_3<Traits>>();
  internal::check_embedded(curves);
  internal::check_inside(curves, domain);
  const auto task = internal::get_filling_task(np, curves, widest.radius(), samples.volume());
  internal::Filler<Flow, Samples, std::remove_reference_t<Visitor_reference>> run(
      curves, samples, task, timer, visitor);
  return run();
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_FILL_H
