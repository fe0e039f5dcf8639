// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CONTAINMENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CONTAINMENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Least_depth.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 * \headerfile CGAL/Volume_filling_curves/coverage.h
 *
 * \brief The struct `Containment` lists the nodes and edges of a curve that are not strictly inside
 * a domain.
 */
struct Containment
{
  /// the nodes on or beyond the boundary, in their order
  std::vector<std::size_t> outside_nodes;

  /// the edges with any point on or beyond the boundary, in their order
  std::vector<std::size_t> outside_edges;

  /// returns whether the whole curve is strictly inside.
  bool is_inside() const { return outside_nodes.empty() && outside_edges.empty(); }
};

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 * \headerfile CGAL/Volume_filling_curves/coverage.h
 *
 * \brief The struct `Wall_distance_3` is the least distance of a curve to the boundary of a domain.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3>
struct Wall_distance_3
{
  /// the distance, in the input's unit; infinity if the curve has no edges
  double distance;

  /// the edge that comes nearest, `(std::size_t)-1` if there is none
  std::size_t edge;

  /// the point of the edge that is nearest to the boundary
  Point_3 point;
};

namespace internal {

template <typename Traits, typename Domain>
Containment find_containment(const Curve_network_3<Traits>& curve,
                             const Domain& domain,
                             Run_watch* watch)
{
  Containment result;
  std::vector<bool> is_inside(curve.number_of_nodes());
  for(std::size_t v = 0; v < is_inside.size(); ++v) {
    check(watch);
    is_inside[v] = domain.is_inside(curve.point(v));
    if(!is_inside[v]) result.outside_nodes.push_back(v);
  }
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    check(watch);
    const std::size_t v = curve.source(e), w = curve.target(e);
    if(!is_inside[v] || !domain.is_triangle_inside(curve.point(v), curve.point(w), curve.point(w)))
      result.outside_edges.push_back(e);
  }
  return result;
}

// Throws std::invalid_argument, with the nodes in the message, if a curve does not lie strictly
// inside a domain.
template <typename Network, typename Domain>
void check_inside(const Network& curve, const Domain& domain)
{
  const Containment outside = find_containment(curve, domain, nullptr);
  if(!outside.outside_nodes.empty())
    throw std::invalid_argument("node " + std::to_string(outside.outside_nodes[0]) +
                                " is not inside the domain");
  if(!outside.outside_edges.empty())
    throw std::invalid_argument("the edge of nodes " +
                                std::to_string(curve.source(outside.outside_edges[0])) + " and " +
                                std::to_string(curve.target(outside.outside_edges[0])) +
                                " meets the boundary of the domain");
}

} // namespace internal

/// \addtogroup PkgVolumeFillingCurvesMeasures
/// @{

/*!
 * finds the nodes and edges of the curve that are not strictly inside the domain, as exactly as the
 * domain answers. Takes a point test of the domain per node and a triangle test per edge.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3`
 *
 * \param curve the curve
 * \param domain the domain
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Containment containment(const Curve_network_3<Traits>& curve,
                                      const Domain& domain,
                                      const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::find_containment(curve, domain, watch);
  });
}

/*!
 * returns the least distance of a curve to the boundary of a domain, and where it is. The minimum
 * is taken over whole edges. For a triangle mesh and for polygons it is exact up to rounding; for
 * other domains it may be too large by 0.1 % of the distance, or of half of the edge. Takes the
 * time of one distance query per edge, which ends at the least distance known, and of few others.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3`
 *
 * \param curve the curve
 * \param domain the domain
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the curve lies inside the domain, see `containment()`
 * \pre the network has no garbage
 *
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Wall_distance_3<typename Traits::Point_3> min_wall_distance(
    const Curve_network_3<Traits>& curve,
    const Domain& domain,
    const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    const internal::Least_depth<ConcurrencyTag, Curve_network_3<Traits>, Domain> depths(
        curve, domain, watch);
    const auto nearest = depths();
    return Wall_distance_3<typename Traits::Point_3>{
        nearest.distance, nearest.edge, internal::to_point(nearest.point, curve.traits())};
  });
}

/// @}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CONTAINMENT_H
