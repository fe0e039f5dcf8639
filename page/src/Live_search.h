// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_LIVE_SEARCH_H
#define VFC_LIVE_SEARCH_H

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/flow/Curve_simplifier.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_search.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>

#include <chrono>
#include <cstddef>
#include <limits>

namespace vfc_page {

// The search of untangle() for a polygon with few edges, in slices of time.
class Live_search
{
  using Curve = CGAL::Volume_filling_curves::Curve_network_3<>;
  using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
  using Search = CGAL::Volume_filling_curves::internal::Polygon_search<Guard, CGAL::Sequential_tag>;

public:
  Live_search(const Curve& curve, std::size_t seed)
      : m_coarse(simplified(curve)), m_search(m_coarse, {}, number_of_chains, seed)
  {}

  // Searches for about this time, and returns whether the search goes on.
  bool run(double seconds)
  {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    return !m_search.run([&] { return Clock::now() < end; });
  }

  // the polygon that it has found so far
  Curve result() const { return m_search.uncertified_result(m_coarse); }

  // Applies the changes that lead to the polygon to the curve of the guard, which is the one that
  // the search began with, and restores its length.
  void apply(Guard& guard) const
  {
    namespace internal = CGAL::Volume_filling_curves::internal;
    const double length = internal::total_length(guard.curve());
    const internal::Clearance_scope<Guard> scope(guard, 0);
    simplify(guard);
    m_search.apply(guard, [] { return true; });
    guard.collect_garbage();
    internal::rescale_to_length(guard, length);
  }

private:
  static constexpr std::size_t number_of_chains = 2; // as untangle() has

  static void simplify(Guard& guard)
  {
    constexpr double any_distance = std::numeric_limits<double>::infinity();
    CGAL::Volume_filling_curves::internal::Curve_simplifier<Guard>(guard, any_distance).run();
    guard.collect_garbage();
  }

  static Curve simplified(Curve curve)
  {
    Guard guard(curve);
    simplify(guard);
    return curve;
  }

  const Curve m_coarse;
  Search m_search;
};

} // namespace vfc_page

#endif // VFC_LIVE_SEARCH_H
