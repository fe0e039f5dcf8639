// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CERTIFIED_MOTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CERTIFIED_MOTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Network_observer.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/guard/Swept_pairs.h>
#include <CGAL/Volume_filling_curves/internal/search/Broad_phase.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A motion of all nodes along straight lines, and the search for a part of it that can be certified
// (section 4.3 of the paper, made exact). The broad phase runs once: the edges that can meet during
// a part of the motion, in whatever number of rounds, are among those that can meet during all of
// it. With walls, all that the curve sweeps must lie inside them. Near linear in the number of
// edges and candidate pairs; tests run in parallel if asked to.
template <typename Network,
          typename Domain_boundary,
          typename ConcurrencyTag,
          typename BroadPhase = Broad_phase>
class Certified_motion
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Traits::Point_3;

public:
  using Rounds = typename Network_observer<Network>::Rounds;

  Certified_motion(const Network& curve,
                   const Vector_field& target,
                   const Clearance_rule& clearance,
                   const Domain_boundary& walls)
      : m_curve(curve),
        m_clearance(clearance),
        m_walls(walls),
        m_start(coordinates(curve)),
        m_target(target),
        m_pairs(BroadPhase(curve, m_start, target, clearance.distance())
                    .template pairs<ConcurrencyTag>(
                        [&](std::size_t e, std::size_t f) { return !share_a_node(curve, e, f); }))
  {}

  // returns whether the curve keeps its clearance where the part `fraction` of the motion ends
  bool keeps_clearance(double fraction) const
  {
    if(!m_clearance.is_active()) return true;
    const Vector_field end = m_start + fraction * (m_target - m_start);
    return holds_for_all(m_pairs.size(),
                         [&](std::size_t k) { return is_pair_clear(m_pairs[k], end); }) &&
           holds_for_all(m_curve.number_of_nodes(),
                         [&](std::size_t v) { return is_corner_clear(v, end); });
  }

  // Certifies the part `fraction` of the motion as a whole, in reverse order of the nodes, or in 2,
  // 4 and 8 smaller rounds (strands that travel together farther than their distance fail as a
  // whole). Returns what was certified, no rounds if all fail.
  Rounds certify(double fraction) const
  {
    const std::vector<Point_3> start = positions(0);
    for(int rounds : {1, 2, 4, 8})
      for(bool is_reversed : {false, true}) {
        Rounds done = {{}, is_reversed};
        bool is_safe = true;
        for(int k = 1; k <= rounds && is_safe; ++k) {
          std::vector<Point_3> after = positions(fraction * k / rounds);
          is_safe =
              is_round_safe({m_curve, k == 1 ? start : done.positions.back(), after, is_reversed});
          done.positions.push_back(std::move(after));
        }
        if(is_safe) return done;
      }
    return {};
  }

private:
  using Edge_pair = std::array<std::uint32_t, 2>;
  using Pair_test = Swept_pairs<Network>;

  static constexpr std::size_t block = 512; // nodes or pairs per task

  template <typename Predicate>
  bool holds_for_all(std::size_t n, const Predicate& predicate) const
  {
    std::atomic<bool> holds{true};
    for_each_block<ConcurrencyTag>(n, block, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end && holds.load(std::memory_order_relaxed); ++k)
        if(!predicate(k)) holds.store(false, std::memory_order_relaxed);
    });
    return holds;
  }

  bool is_round_safe(const Pair_test& test) const
  {
    return holds_for_all(
               m_pairs.size(),
               [&](std::size_t k) { return test.is_pair_safe(m_pairs[k][0], m_pairs[k][1]); }) &&
           holds_for_all(m_curve.number_of_nodes(),
                         [&](std::size_t v) { return is_node_safe(test, v); });
  }

  bool is_node_safe(const Pair_test& test, std::size_t v) const
  {
    const std::size_t degree = m_curve.degree(v);
    if constexpr(Domain_boundary::is_bounded)
      if(!test.is_node_inside(v, m_walls)) return false;
    if(degree == 1) return test.is_edge_safe(m_curve.incident_edge(v, 0));
    for(std::size_t i = 0; i < degree; ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(!test.is_corner_safe(m_curve.neighbor(v, i), v, m_curve.neighbor(v, j))) return false;
    return true;
  }

  bool is_pair_clear(const Edge_pair& pair, const Vector_field& end) const
  {
    return m_clearance.allows_distance(squared_distance(pair, end),
                                       [&] { return squared_distance(pair, m_start); });
  }

  double squared_distance(const Edge_pair& pair, const Vector_field& x) const
  {
    return squared_segment_distance(
        row(x, m_curve.source(pair[0])), row(x, m_curve.target(pair[0])),
        row(x, m_curve.source(pair[1])), row(x, m_curve.target(pair[1])));
  }

  bool is_corner_clear(std::size_t v, const Vector_field& end) const
  {
    const std::size_t degree = m_curve.degree(v);
    for(std::size_t i = 0; i < degree; ++i)
      for(std::size_t j = 0; j < i; ++j) {
        const auto opening = [&](const Vector_field& x) {
          return Clearance_rule::opening(row(x, m_curve.neighbor(v, i)), row(x, v),
                                         row(x, m_curve.neighbor(v, j)));
        };
        if(!m_clearance.allows_opening(opening(end), [&] { return opening(m_start); }))
          return false;
      }
    return true;
  }

  // The positions after the part `fraction`, as they will be stored; inside the swept boxes
  // whatever the rounding, and the very start and target at 0 and 1 even where b - a overflows.
  std::vector<Point_3> positions(double fraction) const
  {
    std::vector<Point_3> points;
    points.reserve(m_curve.number_of_nodes());
    for(std::size_t v = 0; v < m_curve.number_of_nodes(); ++v) {
      const Vector a = row(m_start, v), b = row(m_target, v);
      const Vector x = fraction == 0 ? a : fraction == 1 ? b : Vector(a + fraction * (b - a));
      points.push_back(
          to_point(x.cwiseMax(a.cwiseMin(b)).cwiseMin(a.cwiseMax(b)), m_curve.traits()));
    }
    return points;
  }

  const Network& m_curve;
  Clearance_rule m_clearance;
  const Domain_boundary& m_walls;
  Vector_field m_start, m_target;
  std::vector<Edge_pair> m_pairs;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CERTIFIED_MOTION_H
