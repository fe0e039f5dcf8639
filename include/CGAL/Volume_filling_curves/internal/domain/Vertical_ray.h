// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_VERTICAL_RAY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_VERTICAL_RAY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Inside test for a closed surface: a point is strictly inside if it is not on the surface and the
// ray upwards from it crosses the surface an odd number of times. Exact: a ray that meets an edge
// or a vertex, or runs along a face, counts as moved by (e, e^2, 0) with an infinitesimal e
// (Edelsbrunner and Muecke 1990), which is decided by signs. CGAL's Side_of_triangle_mesh takes
// random rays in such cases, with rounded ends; for coordinates beyond 2^52 times the size of the
// faces, it errs or never ends.
template <typename Kernel>
class Vertical_ray
{
public:
  using Point_3 = typename Kernel::Point_3;
  using Triangle = std::array<Point_3, 3>;

  explicit Vertical_ray(const Point_3& source) : m_source(source) {}

  // adds a face. \pre it is not degenerate
  void add(const Triangle& face)
  {
    m_is_source_on_surface = m_is_source_on_surface || holds_source(face);
    m_is_odd = m_is_odd != is_crossed(face);
  }

  // returns whether the source is inside of the faces added, which must be all that the ray meets
  bool starts_inside() const { return m_is_odd && !m_is_source_on_surface; }

private:
  using Traits = Curve_flow_traits_3<Kernel>;

  bool holds_source(const Triangle& face) const
  {
    const auto is_above = [&](const Point_3& p) { return p.z() > m_source.z(); };
    if(std::all_of(face.begin(), face.end(), is_above)) return false; // as most faces are
    return Exact_predicates<Traits>(Traits()).does_segment_meet_triangle(m_source, m_source,
                                                                         face[0], face[1], face[2]);
  }

  bool is_crossed(const Triangle& face) const
  {
    const int turn = turn_around_ray(face[0], face[1]);
    return turn != 0 && turn_around_ray(face[1], face[2]) == turn &&
           turn_around_ray(face[2], face[0]) == turn &&
           CGAL::orientation(face[0], face[1], face[2], m_source) == -turn;
  }

  // The direction in which the edge passes the moved ray, seen from above: 1 counterclockwise, -1
  // clockwise, 0 if the edge is vertical.
  int turn_around_ray(const Point_3& a, const Point_3& b) const
  {
    const int turn = CGAL::orientation(from_above(a), from_above(b), from_above(m_source));
    if(turn != 0) return turn;
    if(a.y() != b.y()) return a.y() > b.y() ? 1 : -1;
    return a.x() == b.x() ? 0 : (a.x() < b.x() ? 1 : -1);
  }

  static typename Kernel::Point_2 from_above(const Point_3& p) { return {p.x(), p.y()}; }

  Point_3 m_source;
  bool m_is_source_on_surface = false, m_is_odd = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_VERTICAL_RAY_H
