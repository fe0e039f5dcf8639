// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_COVERAGE_H
#define CGAL_VOLUME_FILLING_CURVES_COVERAGE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/containment.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/measures/Crowding.h>
#include <CGAL/Volume_filling_curves/internal/measures/Empty_region_search.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/search/Distance_to_curve.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Coverage.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {

// returns the value that a share of the values does not exceed. \pre sorted, not empty
inline double quantile(const std::vector<double>& sorted, double share)
{
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[(std::max)(static_cast<std::size_t>(rank), std::size_t(1)) - 1];
}

// Distances from the samples to the curve, computed block by block.
template <typename ConcurrencyTag, typename Traits, typename Domain>
std::vector<double> sample_distances(const Curve_network_3<Traits>& curve,
                                     const Domain_samples_3<Traits, Domain>& samples,
                                     Run_watch* watch)
{
  const std::size_t block = 256;
  const Distance_to_curve tree(curve);
  std::vector<double> distances(samples.points().size());
  const auto find_in_block = [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      distances[i] = tree.distance(to_vector(samples.points()[i]));
  };
  for_each_block<ConcurrencyTag>(distances.size(), block, watch, find_in_block);
  return distances;
}

template <typename Traits, typename Domain, typename BoundaryDistance, typename Thickness>
std::vector<Empty_region_3<typename Traits::Point_3>> find_empty_regions(
    const Curve_network_3<Traits>& curve,
    const Domain_samples_3<Traits, Domain>& samples,
    const std::vector<double>& distances,
    const BoundaryDistance& boundary_distance,
    const Thickness& thickness,
    Run_watch* watch = nullptr)
{
  if(unfilled_fraction(samples, distances, thickness) == 0) return {};
  const auto thickness_at = thickness_function(thickness);
  const double sample_volume = samples.volume() / static_cast<double>(samples.points().size());
  const Distance_to_curve tree(curve);
  Empty_region_search<Traits, Domain, BoundaryDistance, decltype(thickness_at)> search(
      tree, samples.domain(), thickness_at, samples.points(), distances, boundary_distance,
      Space_of<Domain>::side(sample_volume), samples.traits(), watch);
  std::vector<Empty_region_3<typename Traits::Point_3>> regions;
  for(const auto& region : search.run())
    regions.push_back({to_point(region.center, samples.traits()), region.radius,
                       sample_volume * static_cast<double>(region.number_of_samples)});
  return regions;
}

} // namespace internal

/// \addtogroup PkgVolumeFillingCurvesMeasures
/// @{

/*!
 * returns the distance from every sample to the nearest point of the curve, or infinity if the
 * curve has no edges. Takes \cgalBigO{(n + m) \log n} time for `n` edges and `m` samples of most
 * curves.
 *
 * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`; the result is the same
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3`
 *
 * \param curve the curve
 * \param samples the samples
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename Traits,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<double> sample_distances(
    const Curve_network_3<Traits>& curve,
    const Domain_samples_3<Traits, Domain>& samples,
    const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::sample_distances<ConcurrencyTag>(curve, samples, watch);
  });
}

/*!
 * returns the statistics of distances from `sample_distances()`. Takes \cgalBigO{m \log m} time for
 * `m` samples.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3`
 * \tparam Thickness a number, or a functor with <tt>double operator()(Point_3 p) const</tt>
 *
 * \param samples the samples
 * \param distances the distances of the samples to the curve
 * \param thickness the thickness r, everywhere or as a function of the point, in the input's unit
 *
 * \pre `distances` has one entry per sample
 *
 * \throws std::invalid_argument if a thickness is not positive and finite
 */
template <typename Traits, typename Domain, typename Thickness>
[[nodiscard]] Coverage coverage(const Domain_samples_3<Traits, Domain>& samples,
                                const std::vector<double>& distances,
                                const Thickness& thickness)
{
  CGAL_precondition_msg(distances.size() == samples.points().size(),
                        "`distances` has one entry per sample");
  Coverage result;
  result.samples = distances.size();
  if(distances.empty()) return result;
  const auto thickness_at = internal::thickness_function(thickness);
  std::vector<double> sorted(distances.size());
  double sum = 0;
  for(std::size_t i = 0; i < sorted.size(); ++i)
    sum += sorted[i] = distances[i] / thickness_at(samples.points()[i]);
  std::sort(sorted.begin(), sorted.end());
  const auto within = std::upper_bound(sorted.begin(), sorted.end(), 1.) - sorted.begin();
  result.mean = sum / static_cast<double>(sorted.size());
  result.p50 = internal::quantile(sorted, .5);
  result.p95 = internal::quantile(sorted, .95);
  result.p99 = internal::quantile(sorted, .99);
  result.max = sorted.back();
  result.fraction_within_r = static_cast<double>(within) / static_cast<double>(sorted.size());
  return result;
}

/*!
 * returns the share of the samples that are farther than 2 r from the curve; it is at most 1 % for
 * a curve that fills the domain, and 0 without samples. Takes linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3`
 * \tparam Thickness a number, or a functor with <tt>double operator()(Point_3 p) const</tt>
 *
 * \param samples the samples
 * \param distances the distances of the samples to the curve, from `sample_distances()`
 * \param thickness the thickness r, everywhere or as a function of the point, in the input's unit
 *
 * \pre `distances` has one entry per sample
 *
 * \throws std::invalid_argument if a thickness is not positive and finite
 */
template <typename Traits, typename Domain, typename Thickness>
[[nodiscard]] double unfilled_fraction(const Domain_samples_3<Traits, Domain>& samples,
                                       const std::vector<double>& distances,
                                       const Thickness& thickness)
{
  CGAL_precondition_msg(distances.size() == samples.points().size(),
                        "`distances` has one entry per sample");
  if(distances.empty()) return 0;
  const auto thickness_at = internal::thickness_function(thickness);
  std::size_t unfilled = 0;
  for(std::size_t i = 0; i < distances.size(); ++i)
    if(distances[i] > 2 * thickness_at(samples.points()[i])) ++unfilled;
  return static_cast<double>(unfilled) / static_cast<double>(distances.size());
}

/*!
 * returns the regions of the domain that the curve did not reach, the largest first.
 *
 * A region is a set of samples farther than 2 r from the curve, connected by segments inside the
 * domain between nearby samples. It contains a ball of radius r/2 that lies inside the domain and
 * farther than 2 r from the curve. At most 256 regions are found. Takes time linear in the number
 * of samples and, for each region, near-linear in the number of those farther than 2 r.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3`
 * \tparam Thickness a number, or a functor with <tt>double operator()(Point_3 p) const</tt>
 *
 * \param curve the curve
 * \param samples the samples
 * \param distances the distances of the samples to the curve, from `sample_distances()`
 * \param thickness the thickness r, everywhere or as a function of the point, in the input's unit
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage, and `distances` has one entry per sample
 *
 * \throws std::invalid_argument if a thickness is not positive and finite
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits,
          typename Domain,
          typename Thickness,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<Empty_region_3<typename Traits::Point_3>> empty_regions(
    const Curve_network_3<Traits>& curve,
    const Domain_samples_3<Traits, Domain>& samples,
    const std::vector<double>& distances,
    const Thickness& thickness,
    const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  CGAL_precondition_msg(distances.size() == samples.points().size(),
                        "`distances` has one entry per sample");
  const auto boundary_distance = [&](std::size_t k) {
    return samples.domain().distance(samples.points()[k]);
  };
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::find_empty_regions(curve, samples, distances, boundary_distance, thickness,
                                        watch);
  });
}

/// @}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_COVERAGE_H
