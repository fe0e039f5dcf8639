// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_LIMITS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_LIMITS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/guard/Swept_pairs.h>
#include <CGAL/Volume_filling_curves/internal/search/Broad_phase.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Motion of all nodes along straight lines, and its limits: the tests that each node and each pair
// of edges that can meet must pass (section 4.3 of the paper, made exact), and the clearance that
// they must keep. The broad phase runs once: edges that can meet while each node moves any fraction
// of its displacement are among those that can meet in the full motion. With a boundary, all that
// the curve sweeps must lie inside it.
template <typename Network, typename Boundary, typename BroadPhase = Broad_phase>
class Motion_limits
{
public:
  using Point_3 = typename Network::Point_3;
  using Swept = Swept_pairs<Network>;

  template <typename ConcurrencyTag>
  Motion_limits(ConcurrencyTag,
                const Network& curve,
                const Vector_field& target,
                const Clearance_rule& clearance,
                const Boundary& boundary)
      : m_curve(curve),
        m_clearance(clearance),
        m_boundary(boundary),
        m_start(coordinates(curve)),
        m_target(target),
        m_pairs(BroadPhase(ConcurrencyTag(), curve, m_start, target, clearance.distance())
                    .template pairs<ConcurrencyTag>(
                        [&](std::size_t e, std::size_t f) { return !share_a_node(curve, e, f); }))
  {}

  const Network& curve() const { return m_curve; }
  bool keep_clearance() const { return m_clearance.is_active(); }

  // the pairs of edges that can meet
  std::size_t number_of_pairs() const { return m_pairs.size(); }
  const std::array<std::uint32_t, 2>& pair(std::size_t k) const { return m_pairs[k]; }

  // Returns the position of node v after a fraction of its displacement, as it will be stored:
  // inside the swept box for any rounding, and exactly the start and the target at 0 and 1, even if
  // their difference overflows.
  Point_3 position(std::size_t v, double fraction) const
  {
    const Vector a = row(m_start, v), b = row(m_target, v);
    const Vector x = fraction == 0 ? a : fraction == 1 ? b : Vector(a + fraction * (b - a));
    return to_point(x.cwiseMax(a.cwiseMin(b)).cwiseMin(a.cwiseMax(b)), m_curve.traits());
  }

  template <typename ConcurrencyTag>
  std::vector<Point_3> positions(double fraction) const
  {
    std::vector<Point_3> points(m_curve.points().begin(), m_curve.points().end());
    if(fraction != 0)
      for_each_index<ConcurrencyTag>(points.size(),
                                     [&](std::size_t v) { points[v] = position(v, fraction); });
    return points;
  }

  // returns whether the edges of pair k are not too close at the end
  bool is_pair_clear(std::size_t k, const std::vector<Point_3>& end) const
  {
    const auto at_end = [&](std::size_t v) { return to_vector(end[v]); };
    return m_clearance.allows_distance(squared_distance(k, at_end),
                                       [&] { return squared_distance(k, at_start()); });
  }

  // returns whether the angles between the edges at v are not too small at the end
  bool is_corner_clear(std::size_t v, const std::vector<Point_3>& end) const
  {
    const auto at_end = [&](std::size_t w) { return to_vector(end[w]); };
    for(std::size_t i = 0; i < m_curve.degree(v); ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(!m_clearance.allows_opening(opening(v, i, j, at_end),
                                       [&] { return opening(v, i, j, at_start()); }))
          return false;
    return true;
  }

  // returns whether the edges of pair k meet at no time
  bool is_pair_safe(std::size_t k, const Swept& swept) const
  {
    return swept.is_pair_safe(m_pairs[k][0], m_pairs[k][1]);
  }

  // returns whether the edges at v meet only in v at all times, and stay inside the boundary
  bool is_node_safe(std::size_t v, const Swept& swept) const
  {
    const std::size_t degree = m_curve.degree(v);
    if constexpr(Boundary::is_bounded)
      if(!swept.is_node_inside(v, m_boundary)) return false;
    if(degree == 1) return swept.is_edge_safe(m_curve.incident_edge(v, 0));
    for(std::size_t i = 0; i < degree; ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(!swept.is_corner_safe(m_curve.neighbor(v, i), v, m_curve.neighbor(v, j))) return false;
    return true;
  }

private:
  auto at_start() const
  {
    return [this](std::size_t v) { return row(m_start, v); };
  }

  template <typename Position>
  double squared_distance(std::size_t k, const Position& x) const
  {
    const auto [e, f] = m_pairs[k];
    return squared_segment_distance(x(m_curve.source(e)), x(m_curve.target(e)),
                                    x(m_curve.source(f)), x(m_curve.target(f)));
  }

  template <typename Position>
  double opening(std::size_t v, std::size_t i, std::size_t j, const Position& x) const
  {
    return Clearance_rule::opening(x(m_curve.neighbor(v, i)), x(v), x(m_curve.neighbor(v, j)));
  }

  const Network& m_curve;
  Clearance_rule m_clearance;
  const Boundary& m_boundary;
  Vector_field m_start, m_target;
  std::vector<std::array<std::uint32_t, 2>> m_pairs;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_LIMITS_H
