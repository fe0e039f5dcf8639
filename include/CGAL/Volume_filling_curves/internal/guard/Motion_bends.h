// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_BENDS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_BENDS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Strand_neighbors.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Limits of bends and of the distance between strands in a motion of all nodes: their values at the
// start, and the edges of the same strand there. Linear to build, constant time per test. A corner
// or a pair of edges whose nodes do not move always passes, hence the shortening of a motion ends.
template <typename Network>
class Motion_bends
{
  using Point_3 = typename Network::Point_3;

public:
  template <typename ConcurrencyTag>
  Motion_bends(ConcurrencyTag, const Network& curve, const Bend_limits<Point_3>& limits)
      : m_curve(curve),
        m_limits(limits),
        m_scales(scales_of_nodes<ConcurrencyTag>(curve, limits)),
        m_neighbors(curve, multiples_of_edge_scales(limits.length_between_strands()))
  {}

  // The margins of the edges for a search of pairs that are nearer than d, or than their limit.
  std::vector<double> margins(double distance) const
  {
    std::vector<double> margins = multiples_of_edge_scales(m_limits.strand_distance);
    for(double& margin : margins) margin = (std::max)(distance, margin); // not NaN
    return margins;
  }

  // returns whether edges e and f may have the squared distance `after`, given the former one,
  // `before()`
  template <typename SquaredDistance>
  bool allows_distance(std::size_t e,
                       std::size_t f,
                       double squared_after,
                       const SquaredDistance& squared_before) const
  {
    const double limit = m_limits.strand_distance * (std::min)(edge_scale(e), edge_scale(f));
    const double d = (std::max)(0., limit);
    return squared_after >= d * d || m_neighbors.are_neighbors(e, f) ||
           squared_after >= squared_before();
  }

  // returns whether the corner at v, of degree 2, may bend as it does at the end. Positions are
  // functions of the node.
  template <typename Start, typename End>
  bool allows_corner(std::size_t v, const Start& start, const End& end) const
  {
    return keeps_limit(radius(v, end), m_limits.bend_radius * m_scales[v],
                       [&] { return radius(v, start); });
  }

private:
  template <typename ConcurrencyTag>
  static std::vector<double> scales_of_nodes(const Network& curve,
                                             const Bend_limits<Point_3>& limits)
  {
    std::vector<double> scales(curve.number_of_nodes());
    for_each_index<ConcurrencyTag>(
        scales.size(), [&](std::size_t v) { scales[v] = limits.scale_at(curve.point(v)); });
    return scales;
  }

  double edge_scale(std::size_t e) const
  {
    return (std::min)(m_scales[m_curve.source(e)], m_scales[m_curve.target(e)]);
  }

  std::vector<double> multiples_of_edge_scales(double factor) const
  {
    std::vector<double> values(m_curve.number_of_edges());
    for(std::size_t e = 0; e < values.size(); ++e) values[e] = factor * edge_scale(e);
    return values;
  }

  template <typename Position>
  double radius(std::size_t v, const Position& x) const
  {
    const Vector p = x(v);
    return bend_radius(p - x(m_curve.neighbor(v, 0)), x(m_curve.neighbor(v, 1)) - p);
  }

  const Network& m_curve;
  const Bend_limits<Point_3>& m_limits;
  const std::vector<double> m_scales; // of the nodes
  const Strand_neighbors<Network> m_neighbors;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_BENDS_H
