// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_ARC_SPLINE_TEST_SUPPORT_H
#define VFC_TEST_ARC_SPLINE_TEST_SUPPORT_H

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/arc_spline.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace arc_spline_test {

using namespace CGAL::Volume_filling_curves;

using Curve = Curve_network_3<>;
using Point_3 = Curve::Point_3;
using Spline = Arc_spline<Point_3>;
using Piece = Arc_spline_piece<Point_3>;
using Points = std::vector<Point_3>;

inline internal::Vector vector(const Point_3& p)
{
  return internal::to_vector(p);
}

// Closed polylines repeat their first point.
inline Curve curve_of(const std::vector<Points>& polylines)
{
  return Curve(polylines);
}

inline std::vector<Piece> pieces(const Spline& spline)
{
  std::vector<Piece> all;
  for(const auto& path : spline.paths)
    all.insert(all.end(), path.pieces.begin(), path.pieces.end());
  return all;
}

inline std::vector<std::size_t> conflicting_nodes(const Spline& spline)
{
  std::vector<std::size_t> nodes;
  for(const Arc_conflict& conflict : spline.conflicts) nodes.push_back(conflict.node);
  return nodes;
}

// Each piece begins where the one before it ends, in its direction.
inline void expect_smooth(const Spline& spline)
{
  for(const auto& path : spline.paths)
    for(std::size_t k = 0; k < path.pieces.size(); ++k) {
      if(k == 0 && !path.is_closed) continue;
      const Piece& last = path.pieces[k == 0 ? path.pieces.size() - 1 : k - 1];
      const Piece& next = path.pieces[k];
      EXPECT_EQ(last.end, next.start);
      if(!last.is_arc() && !next.is_arc()) continue; // a straight corner
      const auto direction = [](const Point_3& p, const Point_3& q) {
        return internal::in_own_units(vector(q) - vector(p)).normalized();
      };
      const auto in = direction(last.corner, last.end), out = direction(next.start, next.corner);
      EXPECT_LT((in - out).norm(), 1e-6);
    }
}

// the radius of the circle through the start, the middle and the end
inline double radius_through_points(const Piece& arc)
{
  const auto a = vector(arc.start) - vector(arc.middle), b = vector(arc.end) - vector(arc.middle);
  return a.norm() * b.norm() * (a - b).norm() / (2 * a.cross(b).norm());
}

inline void expect_arcs_of_corners(const Spline& spline, const Curve& curve)
{
  const std::vector<double> curvatures = node_curvatures(curve);
  double length = 0;
  for(const Piece& piece : pieces(spline)) {
    length += piece.length;
    if(!piece.is_arc()) continue;
    const std::size_t v = piece.node;
    EXPECT_EQ(piece.corner, curve.point(v));
    EXPECT_NEAR(piece.radius * curvatures[v], 1, 1e-12);
    const double rise =
        (vector(piece.middle) - (vector(piece.start) + vector(piece.end)) / 2).norm();
    EXPECT_NEAR(radius_through_points(piece) / piece.radius, 1, 1e-9 + 1e-13 / rise);
    const auto p = vector(piece.corner);
    const double shorter = (std::min)((vector(curve.point(curve.neighbor(v, 0))) - p).norm(),
                                      (vector(curve.point(curve.neighbor(v, 1))) - p).norm());
    EXPECT_NEAR((vector(piece.start) - p).norm() / (shorter / 2), 1, 1e-9);
    EXPECT_NEAR((vector(piece.end) - p).norm() / (shorter / 2), 1, 1e-9);
  }
  EXPECT_NEAR(spline.min_radius, min_bend_radius(curve), 1e-12 * spline.min_radius);
  EXPECT_NEAR(spline.length, length, 1e-9 * length);
  EXPECT_LT(spline.length, CGAL::Volume_filling_curves::length(curve));
}

inline Points regular_polygon(std::size_t n)
{
  Points points;
  for(std::size_t k = 0; k <= n; ++k) {
    const double angle = 2 * CGAL_PI * static_cast<double>(k % n) / static_cast<double>(n);
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  return points;
}

} // namespace arc_spline_test

#endif // VFC_TEST_ARC_SPLINE_TEST_SUPPORT_H
