// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SEGMENT_DISTANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SEGMENT_DISTANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Returns the position on the segment ab, from 0 to 1, of the point nearest to p.
inline double position_on_segment(const Vector& p, const Vector& a, const Vector& b)
{
  const Vector ab = b - a;
  const double length2 = ab.squaredNorm();
  return length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0., 1.) : 0.;
}

inline double squared_distance_to_segment(const Vector& p, const Vector& a, const Vector& b)
{
  return (p - a - position_on_segment(p, a, b) * (b - a)).squaredNorm();
}

// Squared length of the common perpendicular of the segments a + [0, 1] u and c + [0, 1] v, where w
// = a - c, if its feet lie inside both, and otherwise infinity. Segments at an angle below 1e-7
// count as parallel: rounding makes the direction of their cross product meaningless, and a quarter
// of a percent of random parallel segments would seem far too close.
inline double squared_common_perpendicular(const Vector& u, const Vector& v, const Vector& w)
{
  constexpr double parallel = 1e-14; // a squared sine
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double uw = u.dot(w), vw = v.dot(w);
  const double denominator = uu * vv - uv * uv;
  const double s = uv * vw - vv * uw, t = uu * vw - uv * uw;
  const bool are_feet_inside = s > 0 && s < denominator && t > 0 && t < denominator;
  if(!are_feet_inside || denominator < parallel * uu * vv)
    return std::numeric_limits<double>::infinity();
  const Vector normal = u.cross(v);
  const double height = w.dot(normal);
  return height * height / normal.squaredNorm();
}

// Products of six lengths must neither overflow nor underflow.
inline double squared_distance_of_moderate_segments(const Vector& a,
                                                    const Vector& b,
                                                    const Vector& c,
                                                    const Vector& d)
{
  const double squared_perpendicular = squared_common_perpendicular(b - a, d - c, a - c);
  if(std::isfinite(squared_perpendicular)) return squared_perpendicular;
  return (std::min)(
      (std::min)(squared_distance_to_segment(a, c, d), squared_distance_to_segment(b, c, d)),
      (std::min)(squared_distance_to_segment(c, a, b), squared_distance_to_segment(d, a, b)));
}

// The squared distance of the segments ab and cd, in double arithmetic. The common perpendicular
// counts only where its feet lie inside both segments; otherwise, and for parallel segments, an end
// of one is closest to the other, and these four distances are well conditioned. Very small and
// very large segments are scaled by a power of two, which is exact.
inline double squared_segment_distance(const Vector& a,
                                       const Vector& b,
                                       const Vector& c,
                                       const Vector& d)
{
  constexpr double large = 0x1p+100, small = 0x1p-100;
  const double size =
      (b - a).cwiseAbs().cwiseMax((d - c).cwiseAbs()).cwiseMax((c - a).cwiseAbs()).maxCoeff();
  if((size > small && size < large) || !(size > 0) || !std::isfinite(size))
    return squared_distance_of_moderate_segments(a, b, c, d);
  const int exponent = std::ilogb(size);
  const double unit = std::ldexp(1., -exponent);
  return std::ldexp(squared_distance_of_moderate_segments(unit * a, unit * b, unit * c, unit * d),
                    2 * exponent);
}

// The points a + s (b - a) and c + t (d - c) of two segments that are nearest to each other, as s
// and t in [0, 1]; of parallel segments any such two. In plain double arithmetic, for segments of
// moderate lengths; clamps one parameter after the other (Ericson 2005, section 5.1.9).
inline std::pair<double, double> nearest_points(const Vector& a,
                                                const Vector& b,
                                                const Vector& c,
                                                const Vector& d)
{
  constexpr double parallel = 1e-12; // the squared sine below which segments count as parallel
  const Vector u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double uw = u.dot(w), vw = v.dot(w), denominator = uu * vv - uv * uv;
  if(!(uu > 0 && vv > 0)) return {0, 0};
  const double s = denominator > parallel * uu * vv
                       ? std::clamp((uv * vw - vv * uw) / denominator, 0., 1.)
                       : 0.5;
  const double t = (uv * s + vw) / vv;
  if(t >= 0 && t <= 1) return {s, t};
  const double end = std::clamp(t, 0., 1.);
  return {std::clamp((uv * end - uw) / uu, 0., 1.), end};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SEGMENT_DISTANCE_H
