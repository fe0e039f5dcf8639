// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CERTIFIED_MOTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CERTIFIED_MOTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_observer_3.h>
#include <CGAL/Volume_filling_curves/internal/guard/Motion_limits.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <atomic>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for a certifiable fraction of a motion, the same for all nodes. Near-linear in the number
// of edges and candidate pairs; tests run in parallel with a parallel tag.
template <typename Limits, typename ConcurrencyTag>
class Certified_motion
{
  using Point_3 = typename Limits::Point_3;
  using Swept = typename Limits::Swept;
  using Network = std::decay_t<decltype(std::declval<Limits>().curve())>;

public:
  using Rounds = typename Curve_network_observer_3<typename Network::Traits>::Rounds;

  explicit Certified_motion(const Limits& limits, Run_watch* watch = nullptr)
      : m_limits(limits), m_watch(watch)
  {}

  // Certifies the given fraction of the motion as a whole, in reverse order of the nodes, or in 2,
  // 4 and 8 smaller rounds (strands that travel together farther than their distance fail as a
  // whole). Returns the certified rounds, or none if all fail or the clearance is not kept.
  Rounds certify(double fraction) const
  {
    if(!keeps_clearance(fraction)) return {};
    const std::vector<Point_3> start = positions(0);
    for(int rounds : {1, 2, 4, 8})
      for(bool is_reversed : {false, true}) {
        Rounds done = {{}, is_reversed};
        bool is_safe = true;
        for(int k = 1; k <= rounds && is_safe; ++k) {
          std::vector<Point_3> after = positions(fraction * k / rounds);
          is_safe = is_round_safe(
              {m_limits.curve(), k == 1 ? start : done.positions.back(), after, is_reversed});
          done.positions.push_back(std::move(after));
        }
        if(is_safe) return done;
      }
    return {};
  }

private:
  static constexpr std::size_t block = 512; // nodes or pairs per task

  // returns whether the curve keeps its clearance where the part `fraction` of the motion ends
  bool keeps_clearance(double fraction) const
  {
    if(!m_limits.keep_clearance()) return true;
    const std::vector<Point_3> end = positions(fraction);
    return holds_for_all(m_limits.number_of_pairs(),
                         [&](std::size_t k) { return m_limits.is_pair_clear(k, end); }) &&
           holds_for_all(m_limits.curve().number_of_nodes(),
                         [&](std::size_t v) { return m_limits.is_corner_clear(v, end); });
  }

  std::vector<Point_3> positions(double fraction) const
  {
    return m_limits.template positions<ConcurrencyTag>(fraction);
  }

  template <typename Predicate>
  bool holds_for_all(std::size_t n, const Predicate& predicate) const
  {
    std::atomic<bool> holds{true};
    for_each_block<ConcurrencyTag>(n, block, m_watch, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end && holds.load(std::memory_order_relaxed); ++k)
        if(!predicate(k)) holds.store(false, std::memory_order_relaxed);
    });
    return holds;
  }

  bool is_round_safe(const Swept& swept) const
  {
    return holds_for_all(m_limits.number_of_pairs(),
                         [&](std::size_t k) { return m_limits.is_pair_safe(k, swept); }) &&
           holds_for_all(m_limits.curve().number_of_nodes(),
                         [&](std::size_t v) { return m_limits.is_node_safe(v, swept); });
  }

  const Limits& m_limits;
  Run_watch* m_watch; // none if null; it ends a search by Run_stopped
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CERTIFIED_MOTION_H
