// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_TRIANGLE_DISTANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_TRIANGLE_DISTANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Corners of a triangle in double, for computations that need not be exact.
using Corners = std::array<Vector, 3>;

// returns the squared distance of p to the triangle if it is below `bound`, and else `bound`. That
// of a sliver, the direction of whose normal is lost to rounding, may come out too small, but not
// too large.
inline double squared_distance_to_triangle(const Vector& p,
                                           const Corners& corners,
                                           double bound,
                                           bool is_in_own_unit = false)
{
  const auto& [a, b, c] = corners;
  const Vector ab = b - a, ac = c - a, ap = p - a, normal = ab.cross(ac);
  const double square = normal.squaredNorm(), height = normal.dot(ap);
  // sixth powers of lengths may overflow or underflow
  const bool is_moderate = square > 1e-120 && square < 1e200 && std::abs(height) < 1e150;
  if(!is_in_own_unit && !is_moderate) {
    const double size =
        (std::max)({ab.cwiseAbs().maxCoeff(), ac.cwiseAbs().maxCoeff(), ap.cwiseAbs().maxCoeff()});
    if(!std::isfinite(size)) return (std::min)(bound, ap.squaredNorm());
    if(size < min_extent) return 0;
    const double unit = std::ldexp(1., -std::ilogb(size)), squared_unit = unit * unit;
    const double distance = squared_distance_to_triangle(
        unit * ap, {Vector(), unit * ab, unit * ac}, squared_unit * bound, true);
    return (std::min)(bound, distance / squared_unit);
  }
  if(height * height >= bound * square && square > 0) return bound; // the plane is too far
  const Vector turned = normal.cross(ap);
  // the barycentric coordinates of the foot of p, times the square of the normal
  const double of_b = ac.dot(turned), of_c = -ab.dot(turned);
  if(of_b > 0 && of_c > 0 && of_b + of_c < square) return height * height / square;
  return (std::min)({bound, squared_distance_to_segment(p, a, b),
                     squared_distance_to_segment(p, b, c), squared_distance_to_segment(p, c, a)});
}

// returns the squared distance of the segment ab to the triangle, which it does not meet, and the
// position on the segment, from 0 to 1, if it is below `bound`, and else `bound`
inline std::pair<double, double> nearest_to_triangle(const Vector& a,
                                                     const Vector& b,
                                                     const Corners& corners,
                                                     double bound)
{
  std::pair<double, double> nearest = {squared_distance_to_triangle(a, corners, bound), 0};
  const auto take = [&](double squared_distance, double position) {
    if(squared_distance < nearest.first) nearest = {squared_distance, position};
  };
  take(squared_distance_to_triangle(b, corners, nearest.first), 1);
  for(std::size_t i = 0; i < 3; ++i) {
    const Vector &c = corners[i], &d = corners[(i + 1) % 3];
    const double d2 = squared_segment_distance(a, b, c, d);
    if(d2 < nearest.first) take(d2, nearest_points(a, b, c, d).first);
  }
  return nearest;
}

// returns the barycentric coordinates of the point of the triangle that is closest to p; they are
// not negative
inline std::array<double, 3> closest_barycentric_coordinates(const Vector& p,
                                                             const Corners& corners)
{
  const Vector ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const Vector normal = ab.cross(ac), turned = normal.cross(p - corners[0]);
  const double of_b = ac.dot(turned), of_c = -ab.dot(turned), square = normal.squaredNorm();
  if(of_b > 0 && of_c > 0 && of_b + of_c < square)
    return {(square - of_b - of_c) / square, of_b / square, of_c / square};
  std::array<double, 3> best = {1, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Vector side = corners[j] - corners[i];
    const double t = std::clamp(side.dot(p - corners[i]) / side.squaredNorm(), 0., 1.);
    const double d2 = (corners[i] + t * side - p).squaredNorm();
    if(!(d2 < least)) continue;
    least = d2;
    best = {0, 0, 0};
    best[i] = 1 - t;
    best[j] = t;
  }
  return best;
}

// returns how far it is from p along the unit vector u to the triangle, or infinity. A ray through
// a common edge of two triangles meets at least one of them: the sign with which it passes the edge
// comes out opposite for the two, to the last bit. A ray in the plane of a triangle misses it.
inline double distance_along_to_triangle(const Vector& p, const Vector& u, const Corners& corners)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Vector a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
  const double past_bc = u.dot(b.cross(c)), past_ca = u.dot(c.cross(a));
  if((past_bc > 0 && past_ca < 0) || (past_bc < 0 && past_ca > 0)) return infinity;
  const double past_ab = u.dot(a.cross(b));
  const bool is_left = past_bc >= 0 && past_ca >= 0 && past_ab >= 0;
  if(!is_left && !(past_bc <= 0 && past_ca <= 0 && past_ab <= 0)) return infinity;
  const double sum = past_bc + past_ca + past_ab;
  if(sum == 0) return infinity;
  const double t = (past_bc * u.dot(a) + past_ca * u.dot(b) + past_ab * u.dot(c)) / sum;
  return t >= 0 ? t : infinity;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_TRIANGLE_DISTANCE_H
