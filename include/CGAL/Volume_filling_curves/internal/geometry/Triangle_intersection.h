// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_TRIANGLE_INTERSECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_TRIANGLE_INTERSECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Do two closed triangles meet? Exact, and each of them may be a segment or a point, for which
// CGAL's `do_intersect()` leaves the answer unspecified: they meet if and only if an edge of one
// meets the other. Most pairs are told apart before by the plane of one of them. Constant time.
template <typename Kernel>
class Triangle_intersection
{
public:
  using Triangle = std::array<typename Kernel::Point_3, 3>;

  bool do_intersect(const Triangle& s, const Triangle& t) const
  {
    if(is_on_one_side(s, t) || is_on_one_side(t, s)) return false;
    return does_boundary_meet(s, t) || does_boundary_meet(t, s);
  }

private:
  using Traits = Curve_flow_traits_3<Kernel>;

  bool is_on_one_side(const Triangle& plane, const Triangle& t) const
  {
    const Orientation side = m_orientation(plane[0], plane[1], plane[2], t[0]);
    return side != COPLANAR && m_orientation(plane[0], plane[1], plane[2], t[1]) == side &&
           m_orientation(plane[0], plane[1], plane[2], t[2]) == side;
  }

  bool does_boundary_meet(const Triangle& s, const Triangle& t) const
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(m_predicates.does_segment_meet_triangle(s[i], s[(i + 1) % 3], t[0], t[1], t[2]))
        return true;
    return false;
  }

  typename Traits::Orientation_3 m_orientation = Traits().orientation_3_object();
  Exact_predicates<Traits> m_predicates{Traits()};
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_TRIANGLE_INTERSECTION_H
