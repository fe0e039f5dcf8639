// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SEGMENT_PASSAGE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SEGMENT_PASSAGE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SEGMENT_PASSAGE_H
