// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_SIMPLIFY_CURVES_H
#define CGAL_VOLUME_FILLING_CURVES_SIMPLIFY_CURVES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/Curve_simplifier.h>
#include <CGAL/Volume_filling_curves/internal/check_embedded.h>
#include <CGAL/Volume_filling_curves/internal/named_parameters.h>
#include <CGAL/Volume_filling_curves/parameters.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief simplifies curves: removes every node that can be removed by a certified operation.
 *
 * A node is removed if the triangle that it spans with its two neighbors meets the rest of the curves
 * in nothing but these neighbors, so that the result is ambient isotopic to the input. In the end no
 * further node can be removed under the same conditions. Nodes that stay do not move. Pinned nodes,
 * ends of open curves and junctions stay, and a closed curve keeps 3 nodes at least.
 * `Curve_network_3::origin()` tells which node of the input a node was.
 *
 * With a `max_distance` every edge of the result stays within that Fréchet distance of the part of
 * the input that it stands for: both can be run through from end to end, without turning back, such
 * that they are never farther apart. In particular, every point of the input is within that distance
 * of the result, and every point of the result of the input. Distances are computed with `double`s.
 *
 * Nodes that change the curve least are removed first. A tangled curve of 100,000 nodes takes a few
 * seconds.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves, replaced by the result
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{max_distance}
 *     \cgalParamDescription{the largest Fréchet distance between an edge of the result and the part
 *       of the input that it stands for, in the input's unit}
 *     \cgalParamType{`double`, not negative}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{clearance}
 *     \cgalParamDescription{the distance that edges without a common node keep, see
 *       `Isotopy_guard_3::set_clearance()`, in the input's unit}
 *     \cgalParamType{`double`, not negative and finite}
 *     \cgalParamDefault{`0`, for no clearance}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \returns the number of nodes that were removed
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded, with the nodes in the message, if a
 * coordinate is beyond 1e150 or the size below 1e-150, or if a parameter is out of range
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t simplify_curves(Curve_network_3<Traits>& curves,
                            const NamedParameters& np = parameters::default_values())
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double max_distance = internal::parameter_or(np, internal_np::max_distance, infinity);
  const double clearance = internal::parameter_or(np, internal_np::clearance, 0.);
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  if(!(max_distance >= 0)) throw std::invalid_argument("the largest distance must not be negative");
  if(!(clearance >= 0 && clearance < infinity))
    throw std::invalid_argument("the clearance must not be negative, and finite");
  internal::check_embedded(curves);
  Isotopy_guard_3<Traits> guard(curves);
  guard.set_clearance(clearance);
  const std::size_t count =
      internal::Curve_simplifier<Isotopy_guard_3<Traits>>(guard, max_distance).run();
  guard.collect_garbage();
  return count;
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_SIMPLIFY_CURVES_H
