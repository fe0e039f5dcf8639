// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H
#define CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Default_thickness.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/spheres/capped_medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/spheres/node_circles.h>

#include <CGAL/assertions.h>
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
 * `mean_medial_radius()` is their mean along the curve, and says more about the radii.
 *
 * \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param largest the cap, in the input's unit
 * \param number_of_directions how many medial spheres every node has
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws Run_interrupted if that returns `false`
 *
 * \pre the network has no garbage
 * \pre `largest` is positive and finite
 * \pre `number_of_directions` is positive
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<double> medial_radii(
    const Curve_network_3<Traits>& curve,
    double largest,
    std::size_t number_of_directions = 16,
    const NamedParameters& np = parameters::default_values())
{
  const internal::Medial_spheres spheres =
      internal::measured_medial_spheres<ConcurrencyTag>(curve, largest, number_of_directions, np);
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
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws Run_interrupted if that returns `false`
 *
 * \pre the network has no garbage
 * \pre `largest` is positive and finite
 * \pre `number_of_directions` is positive
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<double> least_medial_radii(
    const Curve_network_3<Traits>& curve,
    double largest,
    std::size_t number_of_directions = 16,
    const NamedParameters& np = parameters::default_values())
{
  const internal::Medial_spheres spheres =
      internal::measured_medial_spheres<ConcurrencyTag>(curve, largest, number_of_directions, np);
  std::vector<double> radii(curve.number_of_nodes(), largest);
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    double& radius = radii[spheres.circles()[c].node]; // a junction has several circles
    for(std::size_t l = 0; l < number_of_directions; ++l)
      radius = (std::min)(radius, spheres.radius(c, l));
  }
  return radii;
}

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
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws Run_interrupted if that returns `false`
 *
 * \return 0 if the curve is empty
 *
 * \pre the network has no garbage
 * \pre `largest` is positive and finite
 * \pre `number_of_directions` is positive
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] double mean_medial_radius(const Curve_network_3<Traits>& curve,
                                        double largest,
                                        std::size_t number_of_directions = 16,
                                        const NamedParameters& np = parameters::default_values())
{
  return internal::mean_radius(
      internal::measured_medial_spheres<ConcurrencyTag>(curve, largest, number_of_directions, np),
      internal::node_weights(curve, internal::coordinates(curve)), largest,
      [](std::size_t) { return true; });
}

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
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws Run_interrupted if that returns `false`
 *
 * \pre the network has no garbage
 * \pre `number_of_directions` is positive
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] double default_thickness(const Curve_network_3<Traits>& curve,
                                       std::size_t number_of_directions = 16,
                                       const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  CGAL_precondition_msg(number_of_directions > 0, "`number_of_directions` is positive");
  using Thickness = internal::Default_thickness<Curve_network_3<Traits>, ConcurrencyTag>;
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return Thickness(curve, number_of_directions, watch)();
  });
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_MEDIAL_RADII_H
