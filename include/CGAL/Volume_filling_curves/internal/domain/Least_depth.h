// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_LEAST_DEPTH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_LEAST_DEPTH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
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
// cannot be the nearest. The remaining edges are measured along their length: by a mesh up to
// rounding; in other domains an edge is halved until no point of it can be nearer by more than a
// thousandth of the distance or of half of the edge. One bounded query per edge, and few others.
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
  static constexpr double precision = 1e-3; // relative, in domains that only measure points

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
    if constexpr(Measures_segments<Domain>::value) {
      const auto [distance, position] = m_domain.distance_of_segment(
          m_curve.point(m_curve.source(e)), m_curve.point(m_curve.target(e)));
      return {distance, e, Vector(a + position * (b - a))};
    } else {
      const double at_a = distance(a), at_b = distance(b);
      Nearest_point nearest = at_b < at_a ? Nearest_point{at_b, e, b} : Nearest_point{at_a, e, a};
      halve(a, at_a, b, at_b, precision * half_length(e), nearest);
      return nearest;
    }
  }

  // No point of a segment is nearer than half of the sum of the distances of its ends minus its
  // length.
  void halve(const Vector& a,
             double at_a,
             const Vector& b,
             double at_b,
             double tolerance,
             Nearest_point& nearest) const
  {
    const double least = (at_a + at_b - (b - a).norm()) / 2;
    if(!(least < nearest.distance - (std::max)(tolerance, precision * nearest.distance))) return;
    const Vector middle = (a + b) / 2;
    const double at_middle = distance(middle);
    if(at_middle < nearest.distance) nearest = {at_middle, nearest.edge, middle};
    halve(a, at_a, middle, at_middle, tolerance, nearest);
    halve(middle, at_middle, b, at_b, tolerance, nearest);
  }

  const Network& m_curve;
  const Domain& m_domain;
  Run_watch* m_watch;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_LEAST_DEPTH_H
