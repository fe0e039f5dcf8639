// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H
#define CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_sphere_search.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/spheres/node_circles.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 *
 * \brief returns for each node the mean of its medial radii over all directions, each of them
 * capped at `largest`: how much room there is around the curve at this node.
 *
 * `mean_medial_radius()` is their mean along the curve, and says more about the radii. To color a
 * curve by them write them as `Node_values`.
 *
 * \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param largest the cap, in the input's unit
 * \param number_of_directions how many medial spheres every node has
 *
 * \pre the network has no garbage
 * \pre `largest` is positive and finite
 * \pre `number_of_directions` is positive
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Traits>
[[nodiscard]] std::vector<double> medial_radii(const Curve_network_3<Traits>& curve,
                                               double largest,
                                               std::size_t number_of_directions = 16)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  CGAL_precondition_msg(largest > 0 && std::isfinite(largest), "`largest` is positive and finite");
  CGAL_precondition_msg(number_of_directions > 0, "`number_of_directions` is positive");
  const internal::Vector_field x = internal::coordinates(curve);
  const std::vector<double> unit(curve.number_of_nodes(), largest / 2);
  internal::Medial_sphere_search search(ConcurrencyTag(), x, unit, 2); // found in a single round
  const internal::Medial_spheres spheres =
      search(internal::node_circles(curve, x), number_of_directions);
  std::vector<double> radii(curve.number_of_nodes(), 0.);
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    const auto& circle = spheres.circles()[c];
    double sum = 0;
    for(std::size_t l = 0; l < number_of_directions; ++l)
      sum += (std::min)(spheres.radius(c, l), largest);
    radii[circle.node] += circle.share * sum / static_cast<double>(number_of_directions);
  }
  return radii;
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H
