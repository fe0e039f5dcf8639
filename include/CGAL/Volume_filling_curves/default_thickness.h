// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_DEFAULT_THICKNESS_H
#define CGAL_VOLUME_FILLING_CURVES_DEFAULT_THICKNESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Default_thickness.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 *
 * \brief returns the thickness with which `untangle()` moves a curve if none is given.
 *
 * This is the 25th percentile of the medial radii of all points and directions, those of spheres
 * that touch nothing counting as infinite. It is a length in the input's unit, scales with the
 * curve, does not depend on how it is divided into edges, and is 0 for a curve without extent.
 * Curves with junctions get at least a thickness with which their nodes become about four times as
 * many, or two thousand. Near-linear time for most curves.
 *
 * \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param number_of_directions how many medial spheres every point has
 *
 * \pre the network has no garbage
 * \pre `number_of_directions` is positive
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Traits>
[[nodiscard]] double default_thickness(const Curve_network_3<Traits>& curve,
                                       std::size_t number_of_directions = 16)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  CGAL_precondition_msg(number_of_directions > 0, "`number_of_directions` is positive");
  using Thickness = internal::Default_thickness<Curve_network_3<Traits>, ConcurrencyTag>;
  return Thickness(curve, number_of_directions)();
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_DEFAULT_THICKNESS_H
