// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_CORNER_PROJECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_CORNER_PROJECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Projected_nodes.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Projection of a path towards its bend radius. Corners of nodes 4, 2 and 1 apart are opened in
// turn, since corners of neighbors alone take hundreds of sweeps for a bend.
class Corner_projection
{
  using Path = Projected_nodes::Path;
  using Index = Projected_nodes::Index;
  using Range = Projected_nodes::Range;

public:
  // Takes a factor of the limits. Nodes, limits and path must outlive the projection.
  Corner_projection(const Projected_nodes& nodes,
                    const Shape_limits& limits,
                    const Path& path,
                    double margin)
      : m_nodes(nodes), m_limits(limits), m_path(path), m_margin(margin), m_ring(ring())
  {
    for(const std::size_t apart : {1u, 2u, 4u})
      if(path.size() > 2 * apart)
        m_ranges[apart] =
            nodes.moving_ranges(path, path.is_closed ? path.end : path.end - 2 * apart, 2 * apart);
  }

  // Opens corners, by a factor of their excess.
  void operator()(std::vector<Vector>& x, double relaxation) const
  {
    if(is_too_short(x)) return widen(x);
    open_corners<4>(x, relaxation);
    open_corners<2>(x, relaxation);
    open_corners<1>(x, relaxation);
  }

private:
  // Opens the corners of nodes that are `apart` nodes apart.
  template <std::size_t apart>
  void open_corners(std::vector<Vector>& x, double relaxation) const
  {
    for(const auto& [begin, end] : m_ranges[apart]) {
      std::size_t i = begin;
      for(; i < end && i + 2 * apart < m_path.end; ++i)
        open_corner<apart>(x, m_nodes.nodes() + i, relaxation);
      for(; i < end; ++i) { // around the end of a closed path
        Index corner[2 * apart + 1];
        for(std::size_t k = 0; k <= 2 * apart; ++k) corner[k] = static_cast<Index>(node(i + k));
        open_corner<apart>(x, corner, relaxation);
      }
    }
  }

  // The arc that is tangent to both edges of a corner and touches the shorter one in its middle has
  // the limit for its radius if the sine of half of the turn is q / sqrt(1 + q^2), where q is half
  // of the shorter edge over the radius; the chords of a circle have the sine q. The node in the
  // middle moves half of the excess relative to the outer ones, nodes in between move a share of
  // that, and the mean of all stays: otherwise even bends would move to their inner side, and rings
  // would shrink to points.
  template <std::size_t apart>
  void open_corner(std::vector<Vector>& x, const Index* nodes, double relaxation) const
  {
    const std::size_t v = nodes[apart];
    if(m_nodes.are_held({nodes[0], v, nodes[2 * apart]})) return;
    const Vector in = x[v] - x[nodes[0]], out = x[nodes[2 * apart]] - x[v];
    const double in2 = in.squaredNorm(), out2 = out.squaredNorm(), edge2 = (std::min)(in2, out2);
    const double radius = m_margin * m_limits.bend_radius[v];
    const double diameter2 = 4 * radius * radius;                      // q2 = edge2 / diameter2
    const double divisor = apart == 1 ? diameter2 + edge2 : diameter2; // sine2 = edge2 / divisor
    const double product = std::sqrt(in2 * out2);
    if(!(edge2 > 0) || divisor * in.dot(out) >= (divisor - 2 * edge2) * product) return;
    const double edge = std::sqrt(edge2);
    const Vector bend = edge * (out / std::sqrt(out2) - in / std::sqrt(in2));
    const double size = bend.norm(), most = 2 * edge2 / std::sqrt(divisor);
    if(!(size > most)) return;
    if(apart == 1 && m_nodes.is_held(v))
      return turn_neighbors(x, nodes, (size - most) / (size * edge) * bend);
    const Vector sixth = relaxation * (size - most) / (6 * size) * bend;
    constexpr double n = apart, mean = (n - 1) / (2 * n + 1);
    m_nodes.move(x, v, (2 - mean) * sixth);
    for(std::size_t k = 1; k <= apart; ++k) {
      const Vector shift = (2 - mean - 3 * static_cast<double>(k) / n) * sixth;
      m_nodes.move(x, nodes[apart - k], shift);
      m_nodes.move(x, nodes[apart + k], shift);
    }
  }

  // The neighbors of a pinned node turn around it until its bend, of edges of length 1, has lost
  // the excess. As outer nodes of the corner they would move a sixth of that: the corner at the end
  // of a neck kept a radius of 0.2 r.
  void turn_neighbors(std::vector<Vector>& x, const Index* nodes, const Vector& excess) const
  {
    const std::size_t u = nodes[0], v = nodes[1], w = nodes[2];
    const double number = m_nodes.mobility()[u] + m_nodes.mobility()[w];
    if(number == 0) return;
    const double in = (x[v] - x[u]).norm(), out = (x[w] - x[v]).norm();
    m_nodes.move(x, u, -in / number * excess);
    m_nodes.move(x, w, -out / number * excess);
  }

  // the length of a ring of as many edges, with the mean limit for its radius
  double ring() const
  {
    double length = 0;
    const auto [cosine, sine] = cos_sin(0.5 / static_cast<double>(m_path.size()));
    for(std::size_t i = m_path.begin; i < m_path.end; ++i)
      length += 2 * m_margin * m_limits.bend_radius[node(i)] * sine / cosine;
    return length;
  }

  // Whether a closed curve is shorter than this ring. Its stiffness would shrink it to a point;
  // therefore it is widened, and its corners are not opened. Most curves are far longer, which some
  // of their edges already show.
  bool is_too_short(const std::vector<Vector>& x) const
  {
    if(!m_path.is_closed) return false;
    double length = 0;
    for(std::size_t i = m_path.begin; i < m_path.end && length < m_ring; ++i)
      length += (x[node(i + 1)] - x[node(i)]).norm();
    return length < m_ring;
  }

  // Moves the nodes away from their center.
  void widen(std::vector<Vector>& x) const
  {
    constexpr double rate = 0.02; // by 17 % in the eight sweeps between searches for close strands
    Vector center;
    for(std::size_t i = m_path.begin; i < m_path.end; ++i)
      center += x[node(i)] / static_cast<double>(m_path.size());
    for(std::size_t i = m_path.begin; i < m_path.end; ++i) {
      const std::size_t v = node(i);
      m_nodes.move(x, v, rate * (x[v] - center));
    }
  }

  std::size_t node(std::size_t i) const { return m_nodes.node(m_path, i); }

  const Projected_nodes& m_nodes;
  const Shape_limits& m_limits;
  const Path& m_path;
  const double m_margin;
  const double m_ring;                        // the least length of a closed path
  std::array<std::vector<Range>, 5> m_ranges; // of corners that can move, by `apart`
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_CORNER_PROJECTION_H
