// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_PLANAR_RAYS_QUERY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_PLANAR_RAYS_QUERY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/triangle_distance.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Query that shortens the rays of a plane to their first intersections with triangles, in a single
// descent of the triangles' tree: near the source few triangles meet the plane, and the rays need
// mostly the same ones. The box of the rays excludes triangles beyond rays that are already
// shortened, a third on the bunny (2026-11-23). Lengths have the same bits as ray by ray.
class Planar_rays_query
{
public:
  // Takes the corners of the triangles and the largest absolute value of their coordinates.
  Planar_rays_query(const std::vector<Corners>& triangles, Planar_rays& rays, double largest)
      : m_triangles(triangles),
        m_rays(rays),
        m_absolute_normal(rays.normal.cwiseAbs()),
        m_margin(64 * std::numeric_limits<double>::epsilon() *
                 (std::max)(largest, rays.source.cwiseAbs().maxCoeff()))
  {
    update_bound();
  }

  double bound() const { return m_bound; }

  double entry(const Bbox_3& box) const
  {
    if(!is_near_rays(box)) return std::numeric_limits<double>::infinity();
    const Vector center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                        (box.zmin() + box.zmax()) / 2);
    const Vector half(box.xmax() - center.x(), box.ymax() - center.y(), box.zmax() - center.z());
    const Vector offset = center - m_rays.source;
    const double height = m_rays.normal.dot(offset);
    if(std::abs(height) > m_absolute_normal.dot(half) + m_margin)
      return std::numeric_limits<double>::infinity();
    const Vector gap = (offset.cwiseAbs() - half).cwiseMax(Vector());
    return gap.squaredNorm();
  }

  void visit(std::size_t i)
  {
    const Corners& corners = m_triangles[i];
    const Vector a = corners[0] - m_rays.source, b = corners[1] - m_rays.source,
                 c = corners[2] - m_rays.source;
    if(!does_meet_plane(a, b, c)) return;
    const std::array<Vector, 3> sides = {b.cross(c), c.cross(a), a.cross(b)};
    bool is_shortened = false;
    for(std::size_t first = 0; first < m_rays.size(); first += several)
      is_shortened |= visit(corners, sides, first, (std::min)(first + several, m_rays.size()));
    if(is_shortened) update_bound();
  }

private:
  static constexpr std::size_t several = 16; // rays at a time

  bool does_meet_plane(const Vector& a, const Vector& b, const Vector& c) const
  {
    const double x = m_rays.normal.dot(a), y = m_rays.normal.dot(b), z = m_rays.normal.dot(c);
    return (std::min)((std::min)(x, y), z) <= m_margin &&
           (std::max)((std::max)(x, y), z) >= -m_margin;
  }

  // Tests some of the rays, nearly all of which miss the triangle, by the signs of the volumes that
  // a ray spans with the sides, as in distance_along_to_triangle().
  bool visit(const Corners& corners,
             const std::array<Vector, 3>& sides,
             std::size_t first,
             std::size_t beyond)
  {
    std::array<double, several> least, most;
    const double *x = m_rays.x.data() + first, *y = m_rays.y.data() + first,
                 *z = m_rays.z.data() + first;
    for(std::size_t k = 0; k < beyond - first; ++k) {
      const double a = x[k] * sides[0].x() + y[k] * sides[0].y() + z[k] * sides[0].z(),
                   b = x[k] * sides[1].x() + y[k] * sides[1].y() + z[k] * sides[1].z(),
                   c = x[k] * sides[2].x() + y[k] * sides[2].y() + z[k] * sides[2].z();
      least[k] = (std::min)((std::min)(a, b), c);
      most[k] = (std::max)((std::max)(a, b), c);
    }
    bool is_shortened = false;
    for(std::size_t k = 0; k < beyond - first; ++k) {
      if(least[k] < 0 && most[k] > 0) continue;
      const std::size_t l = first + k;
      const double t = distance_along_to_triangle(m_rays.source, m_rays.direction(l), corners);
      if(!(t < m_rays.lengths[l])) continue;
      m_rays.lengths[l] = t;
      is_shortened = true;
    }
    return is_shortened;
  }

  // Returns whether a box meets the box of the rays.
  bool is_near_rays(const Bbox_3& box) const
  {
    return box.xmin() <= m_high.x() && box.xmax() >= m_low.x() && box.ymin() <= m_high.y() &&
           box.ymax() >= m_low.y() && box.zmin() <= m_high.z() && box.zmax() >= m_low.z();
  }

  void update_bound()
  {
    const Vector margin = Vector::constant(m_margin);
    Vector low, high;
    for(std::size_t l = 0; l < m_rays.size(); ++l) {
      const Vector tip = m_rays.lengths[l] * m_rays.direction(l);
      low = low.cwiseMin(tip);
      high = high.cwiseMax(tip);
    }
    m_low = m_rays.source + low - margin;
    m_high = m_rays.source + high + margin;
    const double reach = m_rays.longest() + m_margin;
    m_bound = reach * reach;
  }

  const std::vector<Corners>& m_triangles;
  Planar_rays& m_rays;
  Vector m_absolute_normal;
  double m_margin; // for the rounding of heights above the plane and of distances
  double m_bound;
  Vector m_low, m_high; // corners of a box around the rays
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_PLANAR_RAYS_QUERY_H
