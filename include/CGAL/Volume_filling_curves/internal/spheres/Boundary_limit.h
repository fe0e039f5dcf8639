// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_BOUNDARY_LIMIT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_BOUNDARY_LIMIT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Limit of medial spheres other than nodes; none by default. Functions, not a template argument of
// the search: fill() would compile that twice, since it also measures a thickness without a
// boundary.
struct Sphere_limit
{
  // see Boundary_limit
  std::function<void(const Medial_spheres&, std::size_t, Planar_rays&)> limit_centers;
  std::function<void(Medial_spheres&, std::size_t, double)> limit_spheres;

  explicit operator bool() const { return bool(limit_centers); }
};

// Medial spheres limited by the boundary of a domain. To cover the domain, the curve must come
// within r of all of it: only the centers must lie inside. To keep clear of the boundary as of
// another strand (section 3.2 of the paper), the spheres must. Nodes that slide along the boundary
// feel no boundary: its share in their motion is orthogonal to it, but for errors of sampled
// directions, which held a curve on a sphere 0.2 r away from a great circle.
template <typename Network, typename Boundary>
class Boundary_limit
{
public:
  Boundary_limit(const Network& curve, const Boundary& boundary, Wall wall)
      : m_curve(curve), m_boundary(boundary), m_wall(wall)
  {}

  // Shortens the paths of centers from a circle's node to the boundary, if only the centers are
  // limited.
  void limit_centers(const Medial_spheres& spheres, std::size_t c, Planar_rays& rays) const
  {
    const std::size_t v = spheres.circles()[c].node;
    if(m_wall != Wall::COVER || slides_along_boundary(v)) return;
    const auto& p = m_curve.point(v);
    rays.source = to_vector(p);
    if(m_boundary.is_farther(rays.source, rays.longest())) return;
    rays.normal = spheres.circles()[c].normal();
    for(std::size_t l = 0; l < rays.size(); ++l) rays.set_direction(l, spheres.direction(c, l));
    m_boundary.shorten(p, rays);
  }

  // Limits the spheres of a circle, if they are. Radii up to `limited_radius` have been limited
  // before.
  void limit_spheres(Medial_spheres& spheres, std::size_t c, double limited_radius) const
  {
    const std::size_t v = spheres.circles()[c].node;
    if(m_wall != Wall::KEEP_CLEAR || slides_along_boundary(v)) return;
    const auto& p = m_curve.point(v);
    double largest = 0;
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l)
      largest = (std::max)(largest, spheres.radius(c, l));
    constexpr double slack = 1 - 1e-9; // rounding of radii
    const double layer = m_boundary.layer();
    const double least = (std::max)((m_boundary.clearance(p, 2 * largest + layer) - layer) / 2,
                                    slack * limited_radius);
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      if(spheres.radius(c, l) < least) continue;
      const double radius = m_boundary.tangent_radius(p, spheres.direction(c, l),
                                                      spheres.radius(c, l), m_curve.traits());
      if(radius < spheres.radius(c, l)) spheres.set(c, l, radius, Medial_spheres::no_node);
    }
  }

private:
  bool slides_along_boundary(std::size_t v) const
  {
    return m_curve.constraint(v).kind() == Node_constraint::Kind::BOUNDARY;
  }

  const Network& m_curve;
  const Boundary& m_boundary;
  Wall m_wall;
};

// \pre the curve and the boundary outlive the limit
template <typename Network, typename Boundary>
Sphere_limit boundary_limit([[maybe_unused]] const Network& curve,
                            [[maybe_unused]] const Boundary& boundary,
                            [[maybe_unused]] Wall wall)
{
  if constexpr(Boundary::is_bounded) {
    const Boundary_limit<Network, Boundary> limit(curve, boundary, wall);
    return {[limit](const Medial_spheres& spheres, std::size_t c, Planar_rays& rays) {
              limit.limit_centers(spheres, c, rays);
            },
            [limit](Medial_spheres& spheres, std::size_t c, double limited_radius) {
              limit.limit_spheres(spheres, c, limited_radius);
            }};
  } else {
    return {};
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_BOUNDARY_LIMIT_H
