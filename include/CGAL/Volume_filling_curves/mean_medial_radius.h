// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_MEAN_MEDIAL_RADIUS_H
#define CGAL_VOLUME_FILLING_CURVES_MEAN_MEDIAL_RADIUS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/capped_medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/spheres/mean_radius.h>
#include <CGAL/Volume_filling_curves/internal/spheres/node_circles.h>

#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 *
 * \brief returns the mean of the medial radii of all nodes and directions, each of them capped at
 * `largest`: how far away the next strand is, in the mean along the curve.
 *
 * A medial sphere touches the curve at a node and holds no other node. Many touch nothing at all,
 * hence the cap; `untangle()` has a curve relax at a given thickness, and 2 of it is a good cap for
 * the result. Nodes count by their shares of the length. In the input's unit. Near-linear time for
 * curves whose nodes are spaced evenly.
 *
 * \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param largest the cap, in the input's unit
 * \param number_of_directions how many medial spheres every node has
 *
 * \return 0 if the curve is empty
 *
 * \pre the network has no garbage
 * \pre `largest` is positive and finite
 * \pre `number_of_directions` is positive
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Traits>
[[nodiscard]] double mean_medial_radius(const Curve_network_3<Traits>& curve,
                                        double largest,
                                        std::size_t number_of_directions = 16)
{
  return internal::mean_radius(
      internal::capped_medial_spheres<ConcurrencyTag>(curve, largest, number_of_directions),
      internal::node_weights(curve, internal::coordinates(curve)), largest,
      [](std::size_t) { return true; });
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_MEAN_MEDIAL_RADIUS_H
