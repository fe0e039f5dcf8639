// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_STRAND_SEPARATOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_STRAND_SEPARATOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/measures/Least_clearance.h>
#include <CGAL/Volume_filling_curves/internal/search/Broad_phase.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Separation of strands that nearly touch and cannot move: the nodes of edges closer than a given
// distance move apart, as far as certified, along the common perpendicular of the edges. The energy
// does not do this: the medial spheres of crossing strands touch nodes of each other beside the
// crossing. Each node moves at most once, for its closest pair of edges, since a tangled bundle has
// many times as many pairs as nodes. Near-linear in the number of edges and of close pairs, which
// are found in parallel with a parallel tag.
template <typename Guard, typename ConcurrencyTag = Sequential_tag>
class Strand_separator
{
  using Network = typename Guard::Curve_network;

public:
  // Takes the distance, and the longest motion of a node.
  Strand_separator(Guard& guard, double distance, double max_motion)
      : m_guard(guard),
        m_curve(guard.curve()),
        m_distance(distance),
        m_max_motion(max_motion),
        m_clearance(m_curve, CGAL_PI * distance),
        m_is_done(m_curve.number_of_nodes(), false)
  {}

  // Returns whether any node moved.
  bool operator()()
  {
    const Vector_field x = coordinates(m_curve);
    const auto are_close = [&](std::size_t e, std::size_t f) {
      return distance(e, f) < m_distance && !m_clearance.are_neighbors(e, f);
    };
    const auto pairs = Broad_phase(ConcurrencyTag(), m_curve, x, x, m_distance)
                           .template pairs<ConcurrencyTag>(are_close);
    std::vector<std::tuple<double, std::size_t, std::size_t>> closest_first;
    for(const auto& [e, f] : pairs) closest_first.push_back({distance(e, f), e, f});
    std::sort(closest_first.begin(), closest_first.end());
    for(const auto& [d, e, f] : closest_first) {
      check_run();
      separate(e, f);
    }
    return m_have_moved;
  }

private:
  Vector source(std::size_t e) const { return to_vector(m_curve.point(m_curve.source(e))); }
  Vector target(std::size_t e) const { return to_vector(m_curve.point(m_curve.target(e))); }

  void separate(std::size_t e, std::size_t f)
  {
    const double missing = m_distance - distance(e, f);
    if(!(missing > 0)) return; // after other motions
    const Vector motion = (std::min)(missing / 2, m_max_motion) * normal_from(f, e);
    for(const std::size_t v : {m_curve.source(e), m_curve.target(e)}) move(v, motion);
    for(const std::size_t v : {m_curve.source(f), m_curve.target(f)}) move(v, -motion);
  }

  double distance(std::size_t e, std::size_t f) const
  {
    return std::sqrt(squared_segment_distance(source(e), target(e), source(f), target(f)));
  }

  // The common perpendicular of the edges; the offset of almost parallel edges; in a plane the
  // vector between their nearest points, which keeps planar curves in their plane.
  Vector normal_from(std::size_t f, std::size_t e) const
  {
    constexpr double min_sine = 0.05;
    const Vector u = (target(e) - source(e)).normalized(), v = (target(f) - source(f)).normalized();
    const Vector offset = (source(e) + target(e) - source(f) - target(f)) / 2;
    const Vector normal = u.cross(v);
    if(!(normal.norm() > min_sine)) return Vector(offset - offset.dot(u) * u).normalized();
    const double height = normal.dot(source(e) - source(f));
    if(height == 0) return chord_from(f, e).normalized();
    return (height > 0 ? 1 : -1) * normal.normalized();
  }

  Vector chord_from(std::size_t f, std::size_t e) const
  {
    const auto [s, t] = nearest_points(source(e), target(e), source(f), target(f));
    return source(e) + s * (target(e) - source(e)) - source(f) - t * (target(f) - source(f));
  }

  void move(std::size_t v, const Vector& motion)
  {
    if(m_curve.is_pinned(v) || m_is_done[v]) return;
    m_is_done[v] = true;
    const Node_set set(m_curve, m_guard.boundary(), v);
    for(const double fraction : {1., 0.25}) {
      const Vector target = set.nearest(to_vector(m_curve.point(v)) + fraction * motion);
      if(!m_guard.move_node(v, to_point(target, m_curve.traits()))) continue;
      m_have_moved = true;
      return;
    }
  }

  Guard& m_guard;
  const Network& m_curve;
  double m_distance, m_max_motion;
  Least_clearance<Network> m_clearance;
  std::vector<bool> m_is_done; // of the nodes
  bool m_have_moved = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_STRAND_SEPARATOR_H
