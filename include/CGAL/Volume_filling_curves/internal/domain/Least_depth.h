// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_LEAST_DEPTH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_LEAST_DEPTH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Least distance of a curve to the boundary of its domain, over whole edges. Distances are
// 1-Lipschitz, hence an edge of length l whose middle is farther than l / 2 plus the best bound
// cannot be the nearest. The remaining edges are measured along their length. One bounded query per
// edge, and few others.
template <typename ConcurrencyTag, typename Network, typename Domain>
class Least_depth
{
  using Point_3 = typename Network::Point_3;

public:
  static constexpr std::size_t null = static_cast<std::size_t>(-1);

  struct Nearest_point
  {
    double distance = std::numeric_limits<double>::infinity();
    std::size_t edge = null;
    Vector point;
  };

  // \pre the curve lies inside the domain
  Least_depth(const Network& curve, const Domain& domain, Run_watch* watch = nullptr)
      : m_curve(curve), m_domain(domain), m_watch(watch)
  {}

  // returns the nearest point; among equally near ones that on the first edge
  Nearest_point operator()() const
  {
    const std::vector<std::size_t> near = near_edges();
    std::vector<Nearest_point> candidates(near.size());
    for_each_block<ConcurrencyTag>(near.size(), 1, m_watch, [&](std::size_t k, std::size_t) {
      candidates[k] = nearest_point_on(near[k]);
    });
    const auto nearest = std::min_element(
        candidates.begin(), candidates.end(),
        [](const Nearest_point& a, const Nearest_point& b) { return a.distance < b.distance; });
    return nearest == candidates.end() ? Nearest_point() : *nearest;
  }

private:
  static constexpr std::size_t stride = 64; // of the edges that give the first bound
  static constexpr std::size_t block = 256;

  Vector source(std::size_t e) const { return to_vector(m_curve.point(m_curve.source(e))); }
  Vector target(std::size_t e) const { return to_vector(m_curve.point(m_curve.target(e))); }
  double half_length(std::size_t e) const { return (target(e) - source(e)).norm() / 2; }

  double distance(const Vector& p) const
  {
    return m_domain.distance(to_point(p, m_curve.traits()));
  }

  double distance_up_to(const Vector& p, double limit) const
  {
    return depth_up_to(m_domain, to_point(p, m_curve.traits()), limit);
  }

  // The distances of the middles of edges, up to bounds from the distances of some.
  std::vector<std::size_t> near_edges() const
  {
    const std::size_t n = m_curve.number_of_edges();
    double bound = std::numeric_limits<double>::infinity();
    for(std::size_t e = 0; e < n; e += stride)
      bound = (std::min)(bound, distance((source(e) + target(e)) / 2));
    std::vector<double> middles(n);
    for_each_block<ConcurrencyTag>(n, block, m_watch, [&](std::size_t begin, std::size_t end) {
      for(std::size_t e = begin; e < end; ++e)
        middles[e] = distance_up_to((source(e) + target(e)) / 2, bound + half_length(e));
    });
    for(const double middle : middles) bound = (std::min)(bound, middle);
    std::vector<std::size_t> near;
    for(std::size_t e = 0; e < n; ++e)
      if(middles[e] <= bound + half_length(e)) near.push_back(e);
    return near;
  }

  Nearest_point nearest_point_on(std::size_t e) const
  {
    const Vector a = source(e), b = target(e);
    const auto [distance, position] = depth_of_segment(m_domain, m_curve.point(m_curve.source(e)),
                                                       m_curve.point(m_curve.target(e)));
    return {distance, e, Vector(a + position * (b - a))};
  }

  const Network& m_curve;
  const Domain& m_domain;
  Run_watch* m_watch;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_LEAST_DEPTH_H
