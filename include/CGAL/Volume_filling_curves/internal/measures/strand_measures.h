// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_STRAND_MEASURES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_STRAND_MEASURES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/measures/Crowding.h>
#include <CGAL/Volume_filling_curves/internal/measures/Doubly_critical_distance.h>
#include <CGAL/Volume_filling_curves/internal/measures/Least_clearance.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 * \headerfile CGAL/Volume_filling_curves/curve_measures.h
 *
 * \brief The struct `Strand_distance_3` is the least distance between two strands of a curve.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3>
struct Strand_distance_3
{
  /// the distance, in the input's unit; infinity if there is only one strand
  double distance;

  /// the two edges, `(std::size_t)-1` if there are none
  std::array<std::size_t, 2> edges;

  /// a point of each that is nearest to the other
  std::array<Point_3, 2> points;
};

/// \addtogroup PkgVolumeFillingCurvesMeasures
/// @{

/*!
 * returns the radius of the thickest tube around the curve that neither kinks nor meets itself: the
 * minimum of `min_bend_radius()` and half the length of the shortest doubly critical chord
 * (Rawdon's polygonal injectivity radius \cgalCite{vfc:r-atk-98}). NaN if the curve has a junction.
 *
 * A chord is doubly critical if, at both of its ends, the distance to the other end turns from
 * growing to shrinking or back; it may join two components. An end of an open curve also counts if
 * the distance to the other end shrinks towards it. Takes near-linear time for curves whose nodes
 * are spaced evenly.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] double polygonal_thickness(const Curve_network_3<Traits>& curve,
                                         const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  if(curve.has_junction()) return std::numeric_limits<double>::quiet_NaN();
  return internal::measured(
      np, [&](internal::Run_watch* watch) { return internal::tube_radius(curve, watch); });
}

/*!
 * returns the length divided by `polygonal_thickness()`, which is a radius: \f$2\pi\f$ for the
 * circle, about 32.7 for the tight trefoil. NaN if the curve has a junction.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] double ropelength(const Curve_network_3<Traits>& curve,
                                const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::total_length(curve) / polygonal_thickness(curve, np);
}

/*!
 * returns the least distance between two segments that are not neighbors, or infinity if all are.
 *
 * Segments are neighbors if they share a node or if less than \f$\pi r\f$ of their component lies
 * between them. Segments of different components are never neighbors. Takes near-linear time for
 * curves whose nodes are spaced evenly.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param r the radius that the curve should keep, in the input's unit; with 0 only segments that
 * share a node are neighbors
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if `r` is negative or NaN
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] double min_clearance(const Curve_network_3<Traits>& curve,
                                   double r = 0,
                                   const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  if(!(r >= 0)) throw std::invalid_argument("the radius of a clearance must not be negative");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::Least_clearance<Curve_network_3<Traits>>(curve, CGAL_PI * r)(watch);
  });
}

/*!
 * returns the least distance between two strands and the points where it is reached, like
 * `min_clearance()`, but for a thickness that may vary.
 *
 * Two edges belong to different strands if they are of different components, or at least
 * \f$\pi r\f$ of the curve lies between them. Where r varies, that of a pair is the mean of the
 * values in the middles of both edges. Takes near-linear time for curves whose nodes are spaced
 * evenly.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Thickness a number, or a functor with <tt>double operator()(Point_3 p) const</tt>
 *
 * \param curve the curve
 * \param thickness the thickness r, everywhere or as a function of the point, in the input's unit
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if a thickness is not positive and finite
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits,
          typename Thickness,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Strand_distance_3<typename Traits::Point_3> min_strand_distance(
    const Curve_network_3<Traits>& curve,
    const Thickness& thickness,
    const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  const auto [distance, edges, points] = internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::Crowding(curve, thickness).closest(watch);
  });
  return {distance,
          edges,
          {internal::to_point(points[0], curve.traits()),
           internal::to_point(points[1], curve.traits())}};
}

/*!
 * returns the share of the length, by whole edges, along which another strand is nearer than r: 0
 * for a curve that keeps its thickness. Strands are those of `min_strand_distance()`. Takes time
 * near-linear in the number of nodes and of pairs of edges nearer than r.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Thickness a number, or a functor with <tt>double operator()(Point_3 p) const</tt>
 *
 * \param curve the curve
 * \param thickness the thickness r, everywhere or as a function of the point, in the input's unit
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if a thickness is not positive and finite
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename Thickness,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] double crowded_fraction(const Curve_network_3<Traits>& curve,
                                      const Thickness& thickness,
                                      const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::Crowding(curve, thickness).template fraction<ConcurrencyTag>(watch);
  });
}

/// @}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_STRAND_MEASURES_H
