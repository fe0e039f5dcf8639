// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_PLANAR_PREDICATES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_PLANAR_PREDICATES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Intersection tests in the plane, by signs of exact orientations. Segments and triangles are
// closed and may be degenerate, which CGAL's predicates do not allow.
using Planar_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Planar_point = Planar_kernel::Point_2;

inline bool do_boxes_meet(const Planar_point& a,
                          const Planar_point& b,
                          const Planar_point& c,
                          const Planar_point& d)
{
  const auto do_meet = [](double s, double t, double u, double v) {
    return (std::min)(s, t) <= (std::max)(u, v) && (std::min)(u, v) <= (std::max)(s, t);
  };
  return do_meet(a.x(), b.x(), c.x(), d.x()) && do_meet(a.y(), b.y(), c.y(), d.y());
}

inline bool do_segments_meet(const Planar_point& a,
                             const Planar_point& b,
                             const Planar_point& c,
                             const Planar_point& d)
{
  if(!do_boxes_meet(a, b, c, d)) return false;
  const Orientation of_c = orientation(a, b, c), of_d = orientation(a, b, d);
  if(of_c * of_d > 0) return false;
  const Orientation of_a = orientation(c, d, a), of_b = orientation(c, d, b);
  // On one line, segments meet if their boxes do.
  return of_a * of_b <= 0;
}

inline bool does_segment_hold(const Planar_point& a, const Planar_point& b, const Planar_point& p)
{
  return do_boxes_meet(a, b, p, p) && orientation(a, b, p) == COLLINEAR;
}

inline bool does_triangle_hold(const std::array<Planar_point, 3>& t, const Planar_point& p)
{
  const Orientation first = orientation(t[0], t[1], p);
  return first != COLLINEAR && orientation(t[1], t[2], p) == first &&
         orientation(t[2], t[0], p) == first;
}

// Whether a triangle and a segment have a point in common: the segment meets a side, or lies
// inside.
inline bool does_triangle_meet_segment(const std::array<Planar_point, 3>& t,
                                       const Planar_point& a,
                                       const Planar_point& b)
{
  return do_segments_meet(t[0], t[1], a, b) || do_segments_meet(t[1], t[2], a, b) ||
         do_segments_meet(t[2], t[0], a, b) || does_triangle_hold(t, a);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_PLANAR_PREDICATES_H
