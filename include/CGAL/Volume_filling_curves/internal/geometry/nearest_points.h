// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_NEAREST_POINTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_NEAREST_POINTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_NEAREST_POINTS_H
