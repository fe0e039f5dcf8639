// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_LIMITS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_LIMITS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/guard/Motion_bends.h>
#include <CGAL/Volume_filling_curves/internal/guard/Swept_pairs.h>
#include <CGAL/Volume_filling_curves/internal/search/Broad_phase.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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
                const Boundary& boundary,
                const Bend_limits<Point_3>& bend_limits = {})
      : m_curve(curve),
        m_clearance(clearance),
        m_boundary(boundary),
        m_start(coordinates(curve)),
        m_target(target)
  {
    if(bend_limits.is_active()) m_bends.emplace(ConcurrencyTag(), curve, bend_limits);
    const double distance = clearance.distance();
    m_pairs = m_bends ? find_pairs<ConcurrencyTag>(m_bends->margins(distance))
                      : find_pairs<ConcurrencyTag>(distance);
  }

  const Network& curve() const { return m_curve; }
  bool keep_clearance() const { return m_clearance.is_active() || m_bends; }

  // the pairs of edges that can meet
  std::size_t number_of_pairs() const { return m_pairs.size(); }
  const std::array<std::uint32_t, 2>& pair(std::size_t k) const { return m_pairs[k]; }

  // Returns the position of node v after a fraction of its displacement, as it will be stored:
  // inside the swept box for any rounding, and exactly the start and the target at 0 and 1.
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
    const double after = squared_distance(k, [&](std::size_t v) { return to_vector(end[v]); });
    const auto before = [&] { return squared_distance(k, at_start()); };
    return m_clearance.allows_distance(after, before) &&
           (!m_bends || m_bends->allows_distance(m_pairs[k][0], m_pairs[k][1], after, before));
  }

  // returns whether the angles between the edges at v are not too small, and v does not bend too
  // tightly, at the end
  bool is_corner_clear(std::size_t v, const std::vector<Point_3>& end) const
  {
    const auto at_end = [&](std::size_t w) { return to_vector(end[w]); };
    for(std::size_t i = 0; i < m_curve.degree(v); ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(!m_clearance.allows_opening(opening(v, i, j, at_end),
                                       [&] { return opening(v, i, j, at_start()); }))
          return false;
    return !m_bends || m_curve.degree(v) != 2 || m_bends->allows_corner(v, at_start(), at_end);
  }

  // returns whether the edges of pair k meet at no time
  bool is_pair_safe(std::size_t k, const Swept& swept) const
  {
    if(m_bends && !do_sweeps_overlap(k)) return true; // found for their distance only
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
  template <typename ConcurrencyTag, typename Margin>
  std::vector<std::array<std::uint32_t, 2>> find_pairs(const Margin& margin) const
  {
    return BroadPhase(ConcurrencyTag(), m_curve, m_start, m_target, margin)
        .template pairs<ConcurrencyTag>(
            [&](std::size_t e, std::size_t f) { return !share_a_node(m_curve, e, f); });
  }

  // whether the boxes around the swept areas of the edges of pair k overlap
  bool do_sweeps_overlap(std::size_t k) const
  {
    return swept_box(m_pairs[k][0]).intersects(swept_box(m_pairs[k][1]));
  }

  Box swept_box(std::size_t e) const
  {
    Box box;
    for(const std::size_t v : {m_curve.source(e), m_curve.target(e)})
      box.extend(row(m_start, v)).extend(row(m_target, v));
    return box;
  }

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
  std::optional<Motion_bends<Network>> m_bends; // if bends are limited
  std::vector<std::array<std::uint32_t, 2>> m_pairs;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_LIMITS_H
