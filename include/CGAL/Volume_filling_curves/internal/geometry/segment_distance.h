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
#include <array>
#include <cmath>
#include <cstddef>
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

// Two segments: the ends of one, and of the other.
using Segment_pair = std::array<Vector, 4>;

// the vector between the nearest points, to the first segment
inline Vector nearest_chord(const Segment_pair& p)
{
  const auto [s, t] = nearest_points(p[0], p[1], p[2], p[3]);
  return (p[0] + s * (p[1] - p[0])) - (p[2] + t * (p[3] - p[2]));
}

// Returns whether two segments that move on a straight line each may meet. Otherwise the middles
// have not turned around each other by a right angle, and are farther apart than the segments are
// long.
inline bool may_meet(const Segment_pair& from, const Segment_pair& to)
{
  const auto twice_apart = [](const Segment_pair& s) { return (s[0] - s[2]) + (s[1] - s[3]); };
  const auto lengths2 = [](const Segment_pair& s) {
    return (s[1] - s[0]).squaredNorm() + (s[3] - s[2]).squaredNorm();
  };
  const Vector before = twice_apart(from), after = twice_apart(to);
  return !(before.dot(after) > 0 && (std::min)(before.squaredNorm(), after.squaredNorm()) >
                                        4 * (std::max)(lengths2(from), lengths2(to)));
}

// six times the volume of the tetrahedron of the ends
inline double signed_volume(const Segment_pair& s)
{
  return (s[1] - s[0]).cross(s[3] - s[2]).dot(s[0] - s[2]);
}

// Returns whether two segments in one plane meet, apart from rounding.
inline bool do_meet_in_plane(const Segment_pair& p)
{
  const Vector u = p[1] - p[0], v = p[3] - p[2], w = p[2] - p[0], normal = u.cross(v);
  const double square = normal.squaredNorm();
  const double s = w.cross(v).dot(normal), t = w.cross(u).dot(normal);
  return square > 0 && s >= 0 && s <= square && t >= 0 && t <= square;
}

// Returns whether two segments whose ends move on straight lines pass through each other an odd
// number of times. In double arithmetic, for geometry that decides nothing; in a plane none do.
inline bool do_pass(const Segment_pair& from, const Segment_pair& to)
{
  if(!may_meet(from, to)) return false;
  const bool is_positive = signed_volume(from) > 0;
  if((signed_volume(to) > 0) == is_positive) return false;
  const auto at = [&](double t) {
    Segment_pair s;
    for(std::size_t k = 0; k < s.size(); ++k) s[k] = from[k] + t * (to[k] - from[k]);
    return s;
  };
  constexpr int halvings = 30;
  double before = 0, after = 1;
  for(int k = 0; k < halvings; ++k) {
    const double middle = (before + after) / 2;
    ((signed_volume(at(middle)) > 0) == is_positive ? before : after) = middle;
  }
  return do_meet_in_plane(at(after));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SEGMENT_DISTANCE_H
