// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_SPACE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_SPACE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Thinned_paths.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_thickness.h>
#include <CGAL/Volume_filling_curves/internal/fingers/Free_ways.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Distance_to_curve.h>
#include <CGAL/Volume_filling_curves/internal/support/Deadline.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Where a curve has not got to in a domain, found by samples of it. Near linear in their number.
template <typename Network, typename Samples>
class Unfilled_space
{
  using Point_3 = typename Network::Point_3;
  using Region = Empty_region_3<Point_3>;

public:
  // Takes the distances of the samples to the boundary, and whether the curve is to keep clear of
  // that.
  Unfilled_space(const Samples& samples, const std::vector<double>& boundary_distances, Wall wall)
      : m_samples(samples), m_boundary_distances(boundary_distances), m_wall(wall)
  {}

  // returns the share of the volume that is farther than twice the thickness from the curve
  template <typename Thickness>
  double fraction(const Network& curve, const Thickness& thickness) const
  {
    return unfilled_fraction(m_samples, distances(curve, thickness), thickness);
  }

  // returns whether it is more than is tolerated, or somewhere much farther: a thin ear of a bunny
  // is less than a hundredth of the volume, but far away
  template <typename Thickness>
  bool is_much(const Network& curve, const Thickness& thickness) const
  {
    const std::vector<double> distances_to_curve = distances(curve, thickness);
    const auto farther_than = [&](double multiple) {
      return unfilled_fraction(m_samples, distances_to_curve,
                               [&](const Point_3& p) { return multiple / 2 * thickness(p); });
    };
    return farther_than(2) > tolerated_unfilled_fraction || farther_than(far_away) > 0;
  }

  template <typename Thickness>
  std::vector<Region> regions(const Network& curve, const Thickness& thickness) const
  {
    return regions(curve, thickness, distances(curve, thickness));
  }

  // returns a point of each region, and points far from the curve, the farthest first: a tip of a
  // thin ear holds no ball that makes it a region
  template <typename Thickness>
  std::vector<Point_3> places(const Network& curve, const Thickness& thickness) const
  {
    const std::vector<double> distances_to_curve = distances(curve, thickness);
    std::vector<Point_3> places;
    for(const Region& region : regions(curve, thickness, distances_to_curve))
      places.push_back(region.point);
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
      if(std::none_of(places.begin(), places.end(), is_near)) places.push_back(p);
    }
    return places;
  }

  // returns ways from places to the curve. After the deadline no further ones are looked for.
  Thinned_paths ways_to(const std::vector<Point_3>& places,
                        const Network& curve,
                        double thickness,
                        const Deadline& deadline) const
  {
    const Distance_to_curve tree(curve);
    Free_ways ways(m_samples.domain(), m_samples.traits(), most_cells);
    Thinned_paths paths(cell_of_paths * thickness);
    for(const Point_3& place : places)
      for(double cell = cell_of_paths; cell >= least_cell; cell /= 2) {
        const auto is_near = [&](const Vector& p) {
          return tree.distance(p) < 2 * cell_of_paths * thickness || deadline.has_passed();
        };
        if(!ways.flood(to_vector(place), cell * thickness, is_near)) continue;
        for(const Vector& p : ways.cells()) paths.add(p);
        break;
      }
    return paths;
  }

private:
  static constexpr double far_away = 3; // from the curve, in units of the thickness
  static constexpr double cell_of_paths = 0.5, least_cell = 0.125; // in units of the thickness
  static constexpr std::size_t most_cells = 1000000;

  template <typename Thickness>
  std::vector<Region> regions(const Network& curve,
                              const Thickness& thickness,
                              const std::vector<double>& distances_to_curve) const
  {
    return find_empty_regions(curve, m_samples, distances_to_curve, &m_boundary_distances,
                              thickness);
  }

  // Of the samples from the curve; 0 where it is to keep clear of the boundary. Driven there, it
  // would be compressed, and stay so.
  template <typename Thickness>
  std::vector<double> distances(const Network& curve, const Thickness& thickness) const
  {
    std::vector<double> distances = sample_distances(curve, m_samples);
    if(m_wall == Wall::KEEP_CLEAR)
      for(std::size_t k = 0; k < distances.size(); ++k)
        if(m_boundary_distances[k] < 2 * thickness(m_samples.points()[k])) distances[k] = 0;
    return distances;
  }

  const Samples& m_samples;
  const std::vector<double>& m_boundary_distances;
  const Wall m_wall;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_SPACE_H
