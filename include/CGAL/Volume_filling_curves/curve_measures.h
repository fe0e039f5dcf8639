// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_CURVE_MEASURES_H
#define CGAL_VOLUME_FILLING_CURVES_CURVE_MEASURES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/curve/network_of_polylines.h>
#include <CGAL/Volume_filling_curves/internal/flow/Direction_preference.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/knots/Linking_numbers.h>
#include <CGAL/Volume_filling_curves/internal/measures/average_crossing_number.h>
#include <CGAL/Volume_filling_curves/internal/measures/strand_measures.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 *
 * \brief The struct `Curve_measures` collects the measures that `measure()` computes.
 *
 * Lengths are in the input's unit. A measure that does not apply is NaN; a minimum over nothing is
 * infinity.
 */
struct Curve_measures
{
  /// the total length of all components
  double length = 0;

  /// see `component_lengths()`
  std::vector<double> component_lengths;

  /// see `total_curvatures()`
  std::vector<double> total_curvatures;

  /// see `max_curvature()`
  double max_curvature = 0;

  /// see `min_bend_radius()`
  double min_bend_radius = 0;

  /// see `polygonal_thickness()`
  double polygonal_thickness = 0;

  /// see `ropelength()`
  double ropelength = 0;

  /// see `min_clearance()`
  double min_clearance = 0;

  /// see `average_crossing_number()`
  double average_crossing_number = 0;

  /// see `linking_matrix()`
  std::vector<std::vector<int>> linking_matrix;
};

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 *
 * \brief The struct `Tightest_bend` is the corner of a curve with the least bend radius.
 */
struct Tightest_bend
{
  /// see `min_bend_radius()`
  double radius;

  /// the node, the first one of several; `(std::size_t)-1` if the curve has no corners
  std::size_t node;
};

/// \addtogroup PkgVolumeFillingCurvesMeasures
/// @{

/*!
 * returns the length of each component, with or without junctions. Takes linear time.
 *
 * All functions on this page only read the curve and can run concurrently. Scaling the curve by a
 * power of two scales their results exactly, barring overflow and underflow.
 *
 * Functions that can run for seconds have the named parameter `progress`, a function that receives
 * a `Run_progress` every few milliseconds, in the thread of the caller. If it returns `false`, they
 * throw `Run_interrupted`.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 *
 * \pre the network has no garbage
 */
template <typename Traits>
[[nodiscard]] std::vector<double> component_lengths(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::lengths_of_components(curve);
}

/// returns the total length of all components. Takes linear time.
/// \tparam Traits a model of `CurveFlowTraits_3`
/// \param curve the curve
/// \pre the network has no garbage
template <typename Traits>
[[nodiscard]] double length(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::total_length(curve);
}

/*!
 * returns the total curvature of each component: the sum of the angles, in radians, by which the
 * curve turns at its nodes; NaN for a component with junctions. Takes linear time.
 *
 * The total curvature of a closed curve is at least \f$2\pi\f$, and more than \f$4\pi\f$ if the
 * curve is knotted \cgalCite{vfc:f-ctcgfn-49}, \cgalCite{vfc:m-tck-50}.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 *
 * \pre the network has no garbage
 */
template <typename Traits>
[[nodiscard]] std::vector<double> total_curvatures(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  std::vector<double> sums(curve.number_of_components(), 0);
  for(std::size_t c = 0; c < sums.size(); ++c)
    sums[c] = internal::has_junction(curve, c) ? std::numeric_limits<double>::quiet_NaN()
                                               : internal::total_curvature(curve, c);
  return sums;
}

/*!
 * returns the least bend radius of the curve's corners, or infinity if there are none. Takes linear
 * time.
 *
 * The bend radius of a corner with the turning angle \f$\theta\f$ is
 * \f$\min(l_1, l_2) / (2 \tan(\theta/2))\f$, the radius of the arc that is tangent to both edges,
 * of lengths \f$l_1\f$ and \f$l_2\f$, and touches the shorter one in its middle (Rawdon's MinRad
 * \cgalCite{vfc:r-atk-98}). For a regular polygon it is the radius of the inscribed circle.
 * Components with junctions are left out.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 *
 * \pre the network has no garbage
 */
template <typename Traits>
[[nodiscard]] double min_bend_radius(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::min_bend_radius(curve);
}

/// returns the corner with the least bend radius, see `min_bend_radius()`. Linear time.
/// \tparam Traits a model of `CurveFlowTraits_3`
/// \param curve the curve
/// \pre the network has no garbage
template <typename Traits>
[[nodiscard]] Tightest_bend tightest_bend(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  const internal::Corner corner = internal::tightest_corner(curve);
  return {corner.bend_radius, corner.node};
}

/// returns for each node the reciprocal of its bend radius, see `min_bend_radius()`; 0 at ends and
/// junctions. Takes linear time.
/// \tparam Traits a model of `CurveFlowTraits_3`
/// \param curve the curve
/// \pre the network has no garbage
template <typename Traits>
[[nodiscard]] std::vector<double> node_curvatures(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::node_curvatures(curve);
}

/// returns the reciprocal of `min_bend_radius()`, 0 if the curve is straight. Takes linear time.
/// \tparam Traits a model of `CurveFlowTraits_3`
/// \param curve the curve
/// \pre the network has no garbage
template <typename Traits>
[[nodiscard]] double max_curvature(const Curve_network_3<Traits>& curve)
{
  return 1 / min_bend_radius(curve);
}

/*!
 * returns the mean number of crossings of the curve's projections along 100 fixed, evenly
 * distributed directions. Crossings between components and within them count alike.
 *
 * Takes \f$O(n \log n + k)\f$ time per direction for \f$n\f$ nodes and \f$k\f$ pairs of segments
 * whose projections come close.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Are_named_parameters<NamedParameters>::value, int> = 0
#endif
          >
[[nodiscard]] double average_crossing_number(
    const Curve_network_3<Traits>& curve, const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::average_crossing_number<ConcurrencyTag>(curve, 1, watch);
  });
}

/*!
 * returns the linking number of each pair of components, 0 if one is not closed. The diagonal
 * is 0.
 *
 * Crossings and their signs are decided with exact predicates. A crossing is positive if the upper
 * strand, turned counterclockwise by less than a half turn, points along the lower one. Takes
 * \f$O(n \log n + k)\f$ time for \f$n\f$ nodes and \f$k\f$ pairs of segments whose projections come
 * close.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if two closed components meet so that their linking number is
 * undefined
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<std::vector<int>> linking_matrix(
    const Curve_network_3<Traits>& curve, const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    internal::Linking_numbers<Curve_network_3<Traits>> numbers(curve, watch);
    const auto matrix = numbers();
    if(matrix) return *matrix;
    const auto [a, b] = numbers.meeting_components();
    throw std::invalid_argument("components " + std::to_string(a) + " and " + std::to_string(b) +
                                " meet, and their linking number is undefined");
  });
}

/*!
 * computes all measures of a curve.
 *
 * \tparam ConcurrencyTag enables parallel algorithms, as for `average_crossing_number()`, which
 * takes most of the time
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param r as for `min_clearance()`
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument as `linking_matrix()` and `min_clearance()`
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Curve_measures measure(const Curve_network_3<Traits>& curve,
                                     double r = 0,
                                     const NamedParameters& np = parameters::default_values())
{
  Curve_measures result;
  result.length = length(curve);
  result.component_lengths = component_lengths(curve);
  result.total_curvatures = total_curvatures(curve);
  result.max_curvature = max_curvature(curve);
  result.min_bend_radius = min_bend_radius(curve);
  result.polygonal_thickness = polygonal_thickness(curve, np);
  result.ropelength = result.length / result.polygonal_thickness;
  result.min_clearance = min_clearance(curve, r, np);
  result.average_crossing_number = average_crossing_number<ConcurrencyTag>(curve, np);
  result.linking_matrix = linking_matrix(curve, np);
  return result;
}

/*!
 * computes all measures of one polyline, or of several polylines as one curve.
 *
 * \tparam PolylineRange a range of points, or a range of such ranges
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines
 * \param r as for `min_clearance()`
 * \param np \vfcNamedParams{Measure_polylines_signature}
 *
 * \throws std::invalid_argument like the constructor of `Curve_network_3` from polylines, and as
 * `linking_matrix()` and `min_clearance()`
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename PolylineRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::is_range_of_items<PolylineRange>, int> = 0
#endif
          >
[[nodiscard]] Curve_measures measure(const PolylineRange& polylines,
                                     double r = 0,
                                     const NamedParameters& np = parameters::default_values())
{
  const auto given = internal::get_parameters<internal::Measure_polylines_signature>(np);
  return measure(internal::network_of_polylines_t<PolylineRange, NamedParameters>(polylines, np), r,
                 parameters::progress(given.progress));
}

/// @}

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 *
 * \brief returns how well curves follow a direction field: the mean by length of the squared cosine
 * of the angle between an edge and the field at its middle.
 *
 * It is 1 if all edges are parallel to the field, 0 if all are perpendicular, and 1/3 for curves
 * without a preferred direction. Edges where the field is zero do not count; without any other
 * edges the result is NaN. Dimensionless. Takes linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam DirectionField a function of `Traits::Point_3` whose result is convertible to
 * `std::array<double, 3>`, or has members `x()`, `y()` and `z()`
 *
 * \param curves the curves
 * \param field the direction field, as for `fill()`: neither sign nor length of the vectors matters
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the field is not finite in the middle of an edge; the message
 * gives the point
 */
template <typename Traits, typename DirectionField>
[[nodiscard]] double alignment(const Curve_network_3<Traits>& curves, const DirectionField& field)
{
  using internal::Vector;
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  double aligned = 0, length = 0;
  for(std::size_t e = 0; e < curves.number_of_edges(); ++e) {
    const Vector a = internal::to_vector(curves.point(curves.source(e)));
    const Vector b = internal::to_vector(curves.point(curves.target(e)));
    const Vector direction =
        internal::unit_direction(field, internal::to_point((a + b) / 2, curves.traits()));
    if(direction == Vector()) continue;
    const double cosine = (b - a).normalized().dot(direction);
    aligned += (b - a).norm() * cosine * cosine;
    length += (b - a).norm();
  }
  return length > 0 ? aligned / length : std::numeric_limits<double>::quiet_NaN();
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_CURVE_MEASURES_H
