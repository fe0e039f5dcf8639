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

namespace internal {

// Medial spheres of a curve up to the radius `largest`, for measures, which do not depend on a
// thickness.
template <typename ConcurrencyTag, typename Network>
Medial_spheres capped_medial_spheres(const Network& curve,
                                     double largest,
                                     std::size_t number_of_directions,
                                     Run_watch* watch = nullptr)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  CGAL_precondition_msg(largest > 0 && std::isfinite(largest), "`largest` is positive and finite");
  CGAL_precondition_msg(number_of_directions > 0, "`number_of_directions` is positive");
  const Vector_field x = coordinates(curve);
  constexpr double cap =
      2; // in units of the thickness: up to that they are found in a single round
  const std::vector<double> thickness(curve.number_of_nodes(), largest / cap);
  Medial_sphere_search search(ConcurrencyTag(), x, thickness, cap, Sphere_limit(), watch);
  return search(node_circles(curve, x), number_of_directions);
}

// The same, for functions without a status. \throws Run_interrupted
template <typename ConcurrencyTag, typename Network, typename NamedParameters>
Medial_spheres measured_medial_spheres(const Network& curve,
                                       double largest,
                                       std::size_t number_of_directions,
                                       const NamedParameters& np)
{
  return measured(np, [&](Run_watch* watch) {
    return capped_medial_spheres<ConcurrencyTag>(curve, largest, number_of_directions, watch);
  });
}

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 *
 * \brief returns for each node the mean of its medial radii over all directions, each capped at
 * `largest`: a measure of the clearance around the curve.
 *
 * `mean_medial_radius()`, which explains medial radii, is their mean along the curve, and takes as
 * long.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param largest the cap, in the input's unit
 * \param number_of_directions the number of medial spheres per node
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws Run_interrupted if `progress` returns `false`
 *
 * \pre the network has no garbage
 * \pre no edge has length zero
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
 * \brief returns for each node the minimum of its medial radii, capped at `largest`: the radius of
 * the thickest tube that neither kinks at the node nor meets another strand there.
 *
 * As the number of directions grows, this tends to the radius of the smallest circle that is
 * tangent to the curve at the node and passes through another node \cgalCite{vfc:gm-gctis-99}. The
 * minimum over all nodes is about `polygonal_thickness()`. Takes as long as `mean_medial_radius()`.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param largest the cap, in the input's unit
 * \param number_of_directions the number of medial spheres per node
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws Run_interrupted if `progress` returns `false`
 *
 * \pre the network has no garbage
 * \pre no edge has length zero
 * \pre `largest` is positive and finite
 * \pre `number_of_directions` is positive
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<double> min_medial_radii(
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
 * \brief returns the mean of the medial radii of all nodes and directions, each capped at
 * `largest`, in the input's unit: the mean radius of the empty spheres that touch the curve.
 *
 * A medial sphere touches the curve at a node and contains no other node. Many spheres touch
 * nothing else, hence the cap; twice the thickness is a good cap for a result of `untangle()`.
 * Nodes are weighted by their share of the length. Takes near-linear time for curves whose nodes
 * are spaced evenly.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param largest the cap, in the input's unit
 * \param number_of_directions the number of medial spheres per node
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws Run_interrupted if `progress` returns `false`
 *
 * \returns 0 if the curve is empty
 *
 * \pre the network has no garbage
 * \pre no edge has length zero
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
 * \brief returns the default thickness of `untangle()` for a curve.
 *
 * This is the 25th percentile of the medial radii of all points and directions; spheres that touch
 * nothing count as infinite. It is a length in the input's unit, scales with the curve, does not
 * depend on the division into edges, and is 0 for a curve smaller than 1e-150. For curves with
 * junctions it is at least the thickness at which the number of nodes grows to about four times the
 * input's, or to two thousand. Takes near-linear time for most curves.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param number_of_directions the number of medial spheres per point
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws Run_interrupted if `progress` returns `false`
 *
 * \pre the network has no garbage
 * \pre no edge has length zero
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
