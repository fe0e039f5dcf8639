// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_WALL_LIMIT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_WALL_LIMIT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/Vector.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// What the walls leave of the radii of medial spheres. To cover the domain, the curve must come
// within r of all of it: only the centres must lie inside. To keep clear of the walls as of another
// strand (section 3.2 of the paper), the spheres must.
template <typename Network, typename Walls>
class Wall_limit
{
public:
  static constexpr bool is_active = Walls::is_bounded;

  Wall_limit(const Network& curve, const Walls& walls, Wall wall)
      : m_curve(curve), m_walls(walls), m_wall(wall)
  {}

  // a radius up to which the walls limit no sphere at node v; if it is below `needed`, no larger one
  // is known
  double free_radius(std::size_t v, double needed) const
  {
    const double reach = m_wall == Wall::COVER ? 1 : 2; // of a sphere, in units of its radius
    return m_walls.clearance(m_curve.point(v), reach * needed) / reach;
  }

  double operator()(std::size_t v, const Vector& direction, double radius) const
  {
    const auto& p = m_curve.point(v);
    return m_wall == Wall::COVER ? m_walls.distance_along(p, direction, radius)
                                 : m_walls.tangent_radius(p, direction, radius, m_curve.traits());
  }

private:
  const Network& m_curve;
  const Walls& m_walls;
  Wall m_wall;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_WALL_LIMIT_H
