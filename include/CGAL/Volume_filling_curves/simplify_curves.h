// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_SIMPLIFY_CURVES_H
#define CGAL_VOLUME_FILLING_CURVES_SIMPLIFY_CURVES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Polylines_in_place.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/flow/Curve_simplifier.h>
#include <CGAL/Volume_filling_curves/internal/guard/Garbage_scope.h>
#include <CGAL/Volume_filling_curves/internal/guard/Motion_record.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/signatures.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Simplification_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief simplifies curves: removes every node that can be removed by a certified operation.
 *
 * A node is removed if the triangle that it spans with its two neighbors meets the rest of the
 * curves only in these neighbors; hence the result is ambient isotopic to the input. At the end no
 * further node can be removed by this rule. Remaining nodes do not move. Pinned nodes, ends of open
 * curves, junctions and sliding nodes that are not `Curve_network_3::is_removable()` stay, and a
 * closed curve keeps at least 3 nodes. `Curve_network_3::origin()` returns the input index of a
 * node.
 *
 * With a `max_distance`, every edge of the result lies within that Fréchet distance of the section
 * of the input that it replaces: two points can traverse both from end to end, never turning back
 * and never farther apart than this. In particular, every point of the input is within that
 * distance of the result, and vice versa. Distances are computed with `double`s.
 *
 * Nodes whose removal changes the curve least are removed first. A tangled curve of 100,000 nodes
 * takes 0.6 seconds.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param np \vfcNamedParams{Simplify_signature}
 *
 * \returns the number of nodes removed, up to the interruption if `progress` ended the run
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded (the message lists the nodes), if a
 * coordinate is beyond 1e150 or the size is below 1e-150, or if a parameter is out of its range
 * (the message names it). The curves are unchanged in that case
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t simplify_curves(Curve_network_3<Traits>& curves,
                            const NamedParameters& np = parameters::default_values())
{
  return simplify_curves(curves, internal::get_parameters<internal::Simplify_signature>(np));
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief simplifies one or more polylines.
 *
 * As usual in \cgal, a polyline is closed if its last point repeats the first; its result is then
 * closed in the same way. See the overload for `Curve_network_3`.
 *
 * \tparam Polylines a model of `SequenceContainer` with `push_back()`. Its items are default
 * constructible: points, objects whose points `point_map` reads and writes, or such containers
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines, replaced by the result
 * \param np \vfcNamedParams{Simplify_polylines_signature}
 *
 * \returns the number of points removed
 *
 * \throws std::invalid_argument like that overload and the constructor of `Curve_network_3` from
 * polylines. After an exception the polylines are unchanged.
 */
template <typename Polylines,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::is_range_of_items<Polylines>, int> = 0
#endif
          >
std::size_t simplify_curves(Polylines& polylines,
                            const NamedParameters& np = parameters::default_values())
{
  const auto parameters = internal::get_parameters<internal::Simplify_polylines_signature>(np);
  internal::Polylines_in_place<Polylines, NamedParameters> in_place(polylines, np);
  const std::size_t count = simplify_curves(in_place.curves(), parameters);
  in_place.store();
  return count;
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// simplifies curves; the parameters come as a struct.
///
/// \tparam Traits a model of `CurveFlowTraits_3`
///
/// \param curves the curves, replaced by the result
/// \param parameters the parameters
///
/// \pre the network has no garbage
///
/// \returns the same as the overload with named parameters, and throws the same exceptions
template <typename Traits>
std::size_t simplify_curves(Curve_network_3<Traits>& curves,
                            const Simplification_parameters& parameters)
{
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  internal::check_parameters(parameters);
  internal::Run_watch watch(internal::Run_watch::never, parameters.progress);
  watch.begin(Run_stage::SIMPLIFYING);
  if(!internal::does_in_time(watch, [&] { internal::check_embedded(curves); })) {
    internal::certify_no_change(curves, parameters.certificate);
    return 0;
  }
  Isotopy_guard_3<Traits> guard(curves);
  if(parameters.certificate) guard.start_recording();
  guard.set_clearance(parameters.clearance);
  const internal::Garbage_scope scope(guard);
  internal::Curve_simplifier<Isotopy_guard_3<Traits>> simplifier(guard, parameters.max_distance);
  const std::size_t count = simplifier.run(&watch);
  guard.collect_garbage();
  if(parameters.certificate) *parameters.certificate = guard.certificate();
  return count;
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_SIMPLIFY_CURVES_H
