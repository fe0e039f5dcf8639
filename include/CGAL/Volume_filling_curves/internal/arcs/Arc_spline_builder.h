// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_SPLINE_BUILDER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_SPLINE_BUILDER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/arcs/Arc_spline.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Arcs at the corners of a polygon. At a corner p whose edges turn by the angle 2 a, the arc that
// is tangent to both edges at the distance t from p has the radius t / tan(a); t is half the
// shorter edge, hence arcs of neighbors do not overlap, and the radius is Rawdon's MinRad. Straight
// corners, ends and junctions have no arc. Plain double, also for edges whose squares underflow;
// linear time. \throws Run_stopped in a Watched_scope
template <typename Network>
class Arc_spline_builder
{
  using Point_3 = typename Network::Point_3;
  using Piece = Arc_spline_piece<Point_3>;
  using Path = Arc_spline_path<Point_3>;

public:
  // \pre the network is embedded and has no garbage
  explicit Arc_spline_builder(const Network& curve) : m_curve(curve) {}

  Arc_spline<Point_3> operator()()
  {
    for(const Curve_strand& strand : strands(m_curve)) m_spline.paths.push_back(path(strand));
    return std::move(m_spline);
  }

private:
  // Arcs that leave less than this share of the edge between them end in one point. A segment
  // between two nearly equal points could run backwards because of rounding.
  static constexpr double min_share = 1e-12;
  static constexpr double min_tangent = 1e-6; // of half a turn that exceeds rounding
  static constexpr double rounding = 8 * std::numeric_limits<double>::epsilon(); // of coordinates

  struct Corner
  {
    double tangent_length = 0;    // may round to 0 beside an edge of the least length
    double half_turn_tangent = 0; // of half the turning angle; 0 if there is no arc
  };

  Vector position(std::size_t v) const { return to_vector(m_curve.point(v)); }
  Point_3 point(const Vector& x) const { return to_point(x, m_curve.traits()); }

  Path path(const Curve_strand& strand)
  {
    const std::vector<std::size_t>& nodes = strand.nodes;
    Path path;
    path.component = m_curve.component(nodes.front());
    path.is_closed = strand.is_closed;
    const std::vector<Corner> corners = corners_of(nodes, path.is_closed);
    std::vector<std::array<Vector, 2>> ends; // of the rest of each edge
    unsigned calls = 0;
    for(std::size_t i = 0; i + 1 < nodes.size(); ++i)
      ends.push_back(ends_of_rest(position(nodes[i]), position(nodes[i + 1]),
                                  corners[i].tangent_length, corners[i + 1].tangent_length));
    for(std::size_t i = 0; i < ends.size(); ++i) {
      check_run_sometimes(calls);
      if(ends[i][0] != ends[i][1]) add(path, segment(nodes[i], ends[i][0], ends[i][1]));
      const Corner& corner = corners[i + 1];
      if(corner.half_turn_tangent > 0)
        add(path, arc(nodes[i + 1], corner, ends[i][1], ends[(i + 1) % ends.size()][0]));
    }
    return path;
  }

  std::vector<Corner> corners_of(const std::vector<std::size_t>& nodes, bool is_closed) const
  {
    std::vector<Corner> corners(nodes.size());
    unsigned calls = 0;
    for(std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      check_run_sometimes(calls);
      corners[i] = corner(nodes[i - 1], nodes[i], nodes[i + 1]);
    }
    if(is_closed)
      corners.front() = corners.back() = corner(nodes[nodes.size() - 2], nodes[0], nodes[1]);
    return corners;
  }

  Corner corner(std::size_t u, std::size_t v, std::size_t w) const
  {
    const Vector in = position(v) - position(u), out = position(w) - position(v);
    const double t = (std::min)(stable_norm(in), stable_norm(out)) / 2;
    const double tangent = half_turn_tangent(in, out);
    return is_straight(t, tangent, position(v)) ? Corner() : Corner{t, tangent};
  }

  // Returns whether the height of an arc above its chord is below the rounding of coordinates.
  static bool is_straight(double t, double tangent, const Vector& p)
  {
    return !std::isfinite(t / tangent) ||
           (tangent < min_tangent && t * tangent <= rounding * p.cwiseAbs().maxCoeff());
  }

  // positions where the arcs at the nodes v and w of an edge begin
  static std::array<Vector, 2> ends_of_rest(const Vector& v, const Vector& w, double tv, double tw)
  {
    const double length = stable_norm(w - v);
    const double least =
        min_share * length + rounding * (v.cwiseAbs().maxCoeff() + w.cwiseAbs().maxCoeff());
    if(tv > 0 && tw > 0 && length - tv - tw <= least) return {(v + w) / 2, (v + w) / 2};
    return {v + tv / length * (w - v), w - tw / length * (w - v)};
  }

  Piece segment(std::size_t node, const Vector& start, const Vector& end) const
  {
    const Point_3 middle = point((start + end) / 2);
    Piece piece{point(start), middle, middle, point(end)};
    piece.length = stable_norm(end - start);
    piece.node = node;
    return piece;
  }

  Piece arc(std::size_t v, const Corner& corner, const Vector& start, const Vector& end)
  {
    const Vector p = position(v);
    const double tangent = corner.half_turn_tangent, secant = std::sqrt(1 + tangent * tangent);
    const Vector middle = p + secant / (1 + secant) * ((start + end) / 2 - p);
    Piece piece{point(start), point(p), point(middle), point(end)};
    const double half_angle =
        tangent <= 1 ? arc_tangent(tangent) : CGAL_PI / 2 - arc_tangent(1 / tangent);
    piece.radius = corner.tangent_length / tangent;
    piece.length = 2 * half_angle * piece.radius;
    piece.node = v;
    m_spline.max_distance =
        (std::max)(m_spline.max_distance, corner.tangent_length * tangent / (1 + secant));
    return piece;
  }

  void add(Path& path, const Piece& piece)
  {
    ++(piece.is_arc() ? m_spline.number_of_arcs : m_spline.number_of_segments);
    m_spline.min_radius = (std::min)(m_spline.min_radius, piece.radius);
    m_spline.length += piece.length;
    path.pieces.push_back(piece);
  }

  const Network& m_curve;
  Arc_spline<Point_3> m_spline;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ARCS_ARC_SPLINE_BUILDER_H
