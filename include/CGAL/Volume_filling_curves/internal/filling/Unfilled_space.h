// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_SPACE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_SPACE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Path_search.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Distance_to_curve.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Space of a domain that a curve has not reached yet, represented by samples. Near-linear in their
// number.
template <typename Network, typename Samples, typename ConcurrencyTag = Sequential_tag>
class Unfilled_space
{
  using Point_3 = typename Network::Point_3;
  using Region = Empty_region_3<Point_3>;
  using Domain = std::decay_t<decltype(std::declval<const Samples&>().domain())>;

public:
  using Concurrency_tag = ConcurrencyTag;

  static constexpr double cell_of_paths = 0.5; // in units of the thickness

  using Distances = Boundary_distances<Domain>;

  // Takes the distances of the samples to the boundary, and how the curve treats it.
  Unfilled_space(const Samples& samples,
                 const Distances& boundary_distances,
                 Wall wall,
                 double wall_distance = 0)
      : m_samples(samples), m_boundary_distances(boundary_distances), m_wall_distance(wall_distance)
  {
    const std::vector<double>& depths = boundary_distances.up_to_limit();
    if(wall == Wall::KEEP_CLEAR && !depths.empty())
      m_max_clear_layer = *std::max_element(depths.begin(), depths.end()) / 2;
  }

  const Samples& samples() const { return m_samples; }

  // returns the distances of the samples to a curve
  std::vector<double> distances(const Network& curve) const
  {
    return sample_distances<ConcurrencyTag>(curve, m_samples);
  }

  // returns the share of the volume farther than twice the thickness from a curve, given the
  // distances to it
  template <typename Thickness>
  double fraction(const std::vector<double>& distances, const Thickness& thickness) const
  {
    return unfilled_fraction(m_samples, to_be_covered(distances, thickness), thickness);
  }

  // returns whether this share is not tolerable, or a point is much farther: the thin ear of a
  // bunny is less than a hundredth of the volume, but far away
  template <typename Thickness>
  bool is_much(const Network& curve, const Thickness& thickness) const
  {
    const std::vector<double> distances_to_curve = to_be_covered(distances(curve), thickness);
    const auto farther_than = [&](double multiple) {
      return unfilled_fraction(m_samples, distances_to_curve,
                               [&](const Point_3& p) { return multiple / 2 * thickness(p); });
    };
    return farther_than(2) > tolerated_unfilled_fraction || farther_than(far_away) > 0;
  }

  // returns the regions that a curve has not reached, given the distances to it
  template <typename Thickness>
  std::vector<Region> regions(const Network& curve,
                              const std::vector<double>& distances,
                              const Thickness& thickness) const
  {
    const auto boundary_distance = [this](std::size_t k) { return m_boundary_distances[k]; };
    return find_empty_regions(curve, m_samples, to_be_covered(distances, thickness),
                              boundary_distance, thickness);
  }

  // returns a point of each region, and other points far from the curve, the farthest first: the
  // tip of a thin ear holds no ball that makes it a region
  template <typename Thickness>
  std::vector<Point_3> unreached_points(const Network& curve, const Thickness& thickness) const
  {
    const std::vector<double> distances_to_curve = to_be_covered(distances(curve), thickness);
    std::vector<Point_3> points;
    for(const Region& region : regions(curve, distances_to_curve, thickness))
      points.push_back(region.point);
    std::vector<std::size_t> far_samples;
    for(std::size_t k = 0; k < distances_to_curve.size(); ++k)
      if(distances_to_curve[k] > far_away * thickness(m_samples.points()[k]))
        far_samples.push_back(k);
    const auto is_farther = [&](std::size_t a, std::size_t b) {
      return distances_to_curve[a] > distances_to_curve[b];
    };
    std::stable_sort(far_samples.begin(), far_samples.end(), is_farther);
    for(const std::size_t k : far_samples) {
      const Point_3& p = m_samples.points()[k];
      const auto is_near = [&](const Point_3& q) {
        return (to_vector(p) - to_vector(q)).norm() < far_away * thickness(p);
      };
      if(std::none_of(points.begin(), points.end(), is_near)) points.push_back(p);
    }
    return points;
  }

  // returns the points of paths from the curve to targets, of no more paths once the run is to stop
  std::vector<Vector> paths_to(const std::vector<Point_3>& targets,
                               const Network& curve,
                               double thickness,
                               Run_watch& watch) const
  {
    std::vector<Vector> points;
    if(targets.empty()) return points;
    const Distance_to_curve tree(curve);
    Path_search paths(m_samples.domain(), m_samples.traits(), max_cells);
    for(const Point_3& target : targets)
      for(double cell = cell_of_paths; cell >= min_cell; cell /= 2) {
        const auto is_near = [&](const Vector& p) {
          return tree.distance(p) < 2 * cell_of_paths * thickness || watch.must_stop();
        };
        if(watch.must_stop()) return points;
        if(!paths.search(to_vector(target), cell * thickness, is_near)) continue;
        const std::vector<Vector> path = paths.path();
        points.insert(points.end(), path.begin(), path.end());
        break;
      }
    return points;
  }

private:
  static constexpr double far_away = 3;     // from the curve, in units of the thickness
  static constexpr double min_cell = 0.125; // in units of the thickness
  static constexpr std::size_t max_cells = 1000000;

  // The distances of the samples to the curve, 0 where it is to keep clear of the boundary: pushed
  // there, the curve would stay compressed. The layer to keep clear of is 2 r thick, but at most
  // half as thick as the domain is deep. Otherwise a tube with a radius of 2 r would have nothing
  // to cover, and any curve would fill it.
  template <typename Thickness>
  std::vector<double> to_be_covered(std::vector<double> distances, const Thickness& thickness) const
  {
    if(m_max_clear_layer == 0 && m_wall_distance == 0) return distances;
    for(std::size_t k = 0; k < distances.size(); ++k) {
      const double r = thickness(m_samples.points()[k]);
      const double clear = (std::max)((std::min)(2 * r, m_max_clear_layer), m_wall_distance);
      if(m_boundary_distances[k] < clear) distances[k] = 0;
    }
    return distances;
  }

  const Samples& m_samples;
  const Distances& m_boundary_distances;
  const double m_wall_distance;
  double m_max_clear_layer = 0; // at the boundary; 0 if the curve covers it
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_SPACE_H
