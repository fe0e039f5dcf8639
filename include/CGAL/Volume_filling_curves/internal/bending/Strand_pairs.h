// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PAIRS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PAIRS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/curve/Strand_neighbors.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/search/Broad_phase.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Pairs of edges of different strands that may come closer than their limit. Near-linear in the
// number of edges. A parallel tag makes the search parallel, with the same order of pairs.
class Strand_pairs
{
public:
  using Index = std::uint32_t;
  using Pair = std::array<Index, 2>;

  // Leaves out pairs farther apart than (1 + slack) times their limit.
  template <typename ConcurrencyTag, typename Network>
  Strand_pairs(ConcurrencyTag, const Network& curve, const Shape_limits& limits, double slack)
  {
    const Vector_field x = coordinates(curve);
    take_edges(curve, limits);
    const Strand_neighbors<Network> neighbors(curve, half_turns(limits));
    std::vector<double> margins = m_distances;
    for(double& margin : margins) margin *= 1 + slack;
    const auto can_touch = [&](std::size_t e, std::size_t f) {
      const auto end = [&](std::size_t k, std::size_t i) { return row(x, m_ends[k][i]); };
      return !are_surely_apart((1 + slack) * distance(e, f), end(e, 0), end(e, 1), end(f, 0),
                               end(f, 1)) &&
             !neighbors.are_neighbors(e, f);
    };
    m_pairs = Broad_phase(ConcurrencyTag(), curve, x, x, margins)
                  .template pairs<ConcurrencyTag>(can_touch);
  }

  const std::vector<Pair>& pairs() const { return m_pairs; }

  // the nodes of an edge
  const Pair& ends(std::size_t e) const { return m_ends[e]; }

  // the distance that two edges must keep, 0 next to a closing ray
  double distance(std::size_t e, std::size_t f) const
  {
    return mean_of_limits(m_distances[e], m_distances[f]);
  }

  // Returns whether the extents of the edges ab and cd, along the line through their middles, show
  // that they are at least a distance apart. Bounds by their lengths instead keep 3.6 times as many
  // pairs, mostly edges one behind the other on parallel strands; 24 fillings of nine domains take
  // 1.5 times as long (2026-11-27).
  static bool are_surely_apart(
      double distance, const Vector& a, const Vector& b, const Vector& c, const Vector& d)
  {
    const Vector twice_apart = (a - c) + (b - d); // of the middles
    const double extents = std::abs((b - a).dot(twice_apart)) + std::abs((d - c).dot(twice_apart));
    const double gap = twice_apart.squaredNorm() - extents; // times twice the length of twice_apart
    return gap > 0 && gap >= 2 * distance * twice_apart.norm();
  }

private:
  // A limit of 0 stands for none.
  static double mean_of_limits(double a, double b) { return a > 0 && b > 0 ? (a + b) / 2 : 0; }

  template <typename Network>
  void take_edges(const Network& curve, const Shape_limits& limits)
  {
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
      const std::size_t v = curve.source(e), w = curve.target(e);
      m_ends.push_back({static_cast<Index>(v), static_cast<Index>(w)});
      m_distances.push_back(mean_of_limits(limits.strand_distance[v], limits.strand_distance[w]));
    }
  }

  // Returns for each edge the length of curve beyond which edges belong to different strands.
  std::vector<double> half_turns(const Shape_limits& limits) const
  {
    std::vector<double> lengths;
    for(std::size_t e = 0; e < m_ends.size(); ++e) {
      const auto [v, w] = m_ends[e];
      const double radius = (limits.bend_radius[v] + limits.bend_radius[w]) / 2;
      lengths.push_back(CGAL_PI * (std::max)(radius, m_distances[e] / 2));
    }
    return lengths;
  }

  std::vector<Pair> m_ends;
  std::vector<double> m_distances; // of each edge
  std::vector<Pair> m_pairs;
};

// Marks the nodes that are at most `reach` edges away from some nodes, not past ends and junctions.
template <typename Network>
void mark_along(const Network& curve,
                const std::vector<std::size_t>& nodes,
                std::size_t reach,
                std::vector<bool>& marks)
{
  for(const std::size_t v : nodes) {
    marks[v] = true;
    for(std::size_t k = 0; k < curve.degree(v); ++k) {
      std::size_t last = v, next = curve.neighbor(v, k);
      for(std::size_t i = 1; i <= reach; ++i) {
        marks[next] = true;
        if(curve.degree(next) != 2) break;
        const std::size_t after_next =
            curve.neighbor(next, curve.neighbor(next, 0) == last ? 1 : 0);
        last = next;
        next = after_next;
      }
    }
  }
}

// Returns which nodes are near some nodes: along the curve, and along the strands next to these.
// Linear in the number of pairs.
template <typename Network>
std::vector<bool> nodes_near(const Network& curve,
                             const Strand_pairs& pairs,
                             const std::vector<std::size_t>& nodes)
{
  constexpr std::size_t reach = 8; // half a turn of the tightest bend takes six edges of a filling
  std::vector<bool> marks(curve.number_of_nodes(), false);
  mark_along(curve, nodes, reach, marks);
  std::vector<std::size_t> beside;
  for(const auto& [e, f] : pairs.pairs())
    for(const auto& [near, other] :
        {std::pair(pairs.ends(e), pairs.ends(f)), std::pair(pairs.ends(f), pairs.ends(e))})
      if((marks[near[0]] || marks[near[1]]) && !(marks[other[0]] && marks[other[1]]))
        beside.insert(beside.end(), other.begin(), other.end());
  mark_along(curve, beside, reach, marks);
  return marks;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PAIRS_H
