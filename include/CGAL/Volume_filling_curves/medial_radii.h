// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H
#define CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/spheres/capped_medial_spheres.h>

#include <CGAL/tags.h>

#include <algorithm>
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
  const internal::Medial_spheres spheres =
      internal::capped_medial_spheres<ConcurrencyTag>(curve, largest, number_of_directions);
  std::vector<double> radii(curve.number_of_nodes(), 0.);
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    const auto& circle = spheres.circles()[c];
    double sum = 0;
    for(std::size_t l = 0; l < number_of_directions; ++l) sum += spheres.radius(c, l);
    radii[circle.node] += circle.share * sum / static_cast<double>(number_of_directions);
  }
  return radii;
}

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 *
 * \brief returns for each node the least of its medial radii, each of them capped at `largest`: the
 * radius of the thickest tube that neither kinks at the node nor meets another strand there.
 *
 * Up to the number of directions that is the radius of the smallest circle that is tangent to the
 * curve at the node and passes through another node (Gonzalez and Maddocks 1999). The least of them
 * all is about `polygonal_thickness()`.
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
[[nodiscard]] std::vector<double> least_medial_radii(const Curve_network_3<Traits>& curve,
                                                     double largest,
                                                     std::size_t number_of_directions = 16)
{
  const internal::Medial_spheres spheres =
      internal::capped_medial_spheres<ConcurrencyTag>(curve, largest, number_of_directions);
  std::vector<double> radii(curve.number_of_nodes(), largest);
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    double& radius = radii[spheres.circles()[c].node]; // a junction has several circles
    for(std::size_t l = 0; l < number_of_directions; ++l)
      radius = (std::min)(radius, spheres.radius(c, l));
  }
  return radii;
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H
