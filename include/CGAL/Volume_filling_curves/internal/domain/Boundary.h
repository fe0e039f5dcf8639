// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_BOUNDARY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_BOUNDARY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Boundary of a domain for the flow: tests of triangles, as certain as the domain's answers, and
// the largest radius of a sphere inside that touches a node. Distance queries to a tree of faces
// are slow far from the surface; hence distances at the centers of the cells of a grid are measured
// once and cached. The distance is 1-Lipschitz, hence the cached values give lower bounds, which
// answer nearly all queries. The distance of the point itself is measured only near the boundary,
// where queries are fast. Answers do not depend on the order of the queries. Safe to query in
// parallel.
template <typename Domain>
class Boundary
{
  using Point_3 = typename Domain::Point_3;

public:
  static constexpr bool is_bounded = true;

  // \throws std::invalid_argument if the box of the domain is empty or infinite, or so small that
  // squares underflow
  explicit Boundary(const Domain& domain) : m_domain(&domain)
  {
    const CGAL::Bbox_3 box = domain.bbox();
    m_low = {box.xmin(), box.ymin(), box.zmin()};
    if(!(box.xmin() <= box.xmax() && box.ymin() <= box.ymax() && box.zmin() <= box.zmax()))
      throw std::invalid_argument("the box of the domain is empty");
    const double diagonal = stable_norm(Vector(box.xmax(), box.ymax(), box.zmax()) - m_low);
    if(!std::isfinite(diagonal)) throw std::invalid_argument("the domain is unbounded");
    if(diagonal < min_extent) throw std::invalid_argument("the domain is smaller than 1e-150");
    m_rounding = rounding_in(box, slack * diagonal);
    m_cell = diagonal / cells_along_diagonal;
    for(int i = 0; i < 3; ++i)
      m_size[i] = static_cast<std::size_t>((box.max(i) - box.min(i)) / m_cell) + 1;
    if(Space_of<Domain>::is_plane) m_middle[2] = 0;
    const std::size_t n = m_size[0] * m_size[1] * m_size[2];
    m_distance = std::make_unique<std::atomic<double>[]>(n);
    for(std::size_t k = 0; k < n; ++k) m_distance[k].store(unknown, std::memory_order_relaxed);
  }

  const Domain& domain() const { return *m_domain; }

  // Sets the least distance of inside triangles to the boundary, and the width of the layer along
  // the boundary that counts as outside for the flow. \pre the layer is no wider than the distance
  void set_wall_distance(double distance, double layer)
  {
    m_wall_distance = (std::max)(0., distance); // 0 for NaN
    m_layer = layer;
  }
  double wall_distance() const { return m_wall_distance; }
  double layer() const { return m_layer; }

  // returns whether the closed triangle lies inside, far enough from the boundary. \pre p does
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    const Vector x = to_vector(p), y = to_vector(q), z = to_vector(r);
    if(Space_of<Domain>::is_plane && (y.z() != 0 || z.z() != 0)) return false;
    const double needed = m_wall_distance + (std::max)((y - x).norm(), (z - x).norm());
    return clearance(p, needed) > needed ||
           (m_domain->is_triangle_inside(p, q, r) &&
            (m_wall_distance == 0 ||
             Depth_test<Domain>(*m_domain, m_wall_distance + m_rounding)(x, y, z)));
  }

  // Returns a lower bound of the distance from p to the boundary: any bound above `needed`, or
  // otherwise the distance itself, up to rounding errors. \pre p lies inside
  double clearance(const Point_3& p, double needed) const
  {
    const double bound = conservative(bound_of_cell(to_vector(p)));
    if(bound > needed) return bound;
    // a distance that exceeds `needed` even with rounding
    const double enough = (needed + 2 * m_rounding) * (1 + 2 * slack);
    return conservative(depth_up_to(*m_domain, p, enough));
  }

  // returns whether the cached distances show that x, inside, is farther from the boundary
  bool is_farther(const Vector& x, double distance) const
  {
    return conservative(bound_of_cell(x)) > distance + m_layer;
  }

  // Shortens rays from p to the points where they leave the domain or reach the layer.
  void shorten(const Point_3& p, Planar_rays& rays) const
  {
    if(m_layer > 0) return shorten_to_layer(p, rays);
    if constexpr(Has_surface<Domain>::value)
      if(has_surface(*m_domain)) return m_domain->shorten(rays);
    using Vector_3 = typename Domain::Vector_3;
    const double clear = clearance(p, rays.longest());
    for(std::size_t l = 0; l < rays.size(); ++l)
      if(rays.lengths[l] >= clear)
        rays.lengths[l] =
            m_domain->distance_along(p, Vector_3(rays.x[l], rays.y[l], rays.z[l]), rays.lengths[l]);
  }

  // Returns the radius, at most `limit`, of the largest sphere inside that touches p and has its
  // center in the direction from p. Larger spheres contain smaller ones, hence bisection finds it.
  template <typename Traits>
  double tangent_radius(const Point_3& p,
                        const Vector& direction,
                        double limit,
                        const Traits& traits) const
  {
    const Vector x = to_vector(p);
    const auto is_inside = [&](double radius) {
      const Point_3 center = to_point(Vector(x + radius * direction), traits);
      return m_domain->is_inside(center) &&
             m_domain->distance(center) - m_layer >= (1 - tolerance) * radius;
    };
    if(is_inside(limit)) return limit;
    double low = 0, high = limit;
    while(high - low > tolerance * high) {
      const double middle = (low + high) / 2;
      (is_inside(middle) ? low : high) = middle;
      if(high < min_radius * limit) break;
    }
    return high;
  }

private:
  // Medial spheres only steer the flow, for which four digits are enough: 14 halvings, and more for
  // small radii. After 20 of them a sphere counts as a point.
  static constexpr double tolerance = 1e-4;  // of a radius, relative
  static constexpr double min_radius = 1e-6; // in units of the limit
  // More cells give closer bounds, but the distance at each is measured once. The box has at most
  // 55,000 cells in space and 132,000 in a plane, 8 bytes each.
  static constexpr double cells_along_diagonal = Space_of<Domain>::is_plane ? 512 : 64;
  static constexpr double slack = 1e-9; // of distances, for rounding
  static constexpr double unknown = -1;

  // Each step is as long as the known distance to the layer. Towards a plane, steps shrink in
  // proportion: eight of them leave the share (1 - cos a)^8 of the way at an angle a to its normal,
  // less than 5 % up to 71 degrees.
  void shorten_to_layer(const Point_3& p, Planar_rays& rays) const
  {
    constexpr int max_steps = 8;
    constexpr double last_step = 0.05; // of the length
    const double clear = clearance(p, rays.longest() + m_layer) - m_layer;
    const Vector start = to_vector(p);
    for(std::size_t l = 0; l < rays.size(); ++l) {
      const double length = rays.lengths[l];
      double step = (std::max)(clear, 0.), reached = step;
      for(int k = 1; k < max_steps && reached < length && step > last_step * length; ++k) {
        const Vector x = start + reached * rays.direction(l);
        const double needed = m_layer + length - reached;
        step = depth_up_to(*m_domain, Point_3(x.x(), x.y(), x.z()), needed) - m_layer;
        reached += (std::max)(step, 0.);
      }
      rays.lengths[l] = (std::min)(reached, length);
    }
  }

  double conservative(double distance) const { return distance * (1 - slack) - m_rounding; }

  double bound_of_cell(const Vector& x) const
  {
    std::size_t k = 0;
    Vector center;
    for(int i = 2; i >= 0; --i) {
      const double index = std::floor((x[i] - m_low[i]) / m_cell);
      const std::size_t last = m_size[i] - 1;
      const std::size_t c =
          !(index > 0) ? 0 : (std::min)(static_cast<std::size_t>((std::min)(index, 1e6)), last);
      k = k * m_size[i] + c;
      center[i] = m_low[i] + (static_cast<double>(c) + m_middle[i]) * m_cell;
    }
    double d = m_distance[k].load(std::memory_order_relaxed);
    if(d == unknown) {
      d = depth(*m_domain, Point_3(center.x(), center.y(), center.z()));
      m_distance[k].store(d, std::memory_order_relaxed);
    }
    return d - (x - center).norm();
  }

  const Domain* m_domain;
  Vector m_low;
  double m_cell, m_rounding; // of distances
  double m_wall_distance = 0, m_layer = 0;
  std::size_t m_size[3];          // cells along the axes
  Vector m_middle{0.5, 0.5, 0.5}; // of the first cell, in cells from its corner
  std::unique_ptr<std::atomic<double>[]> m_distance;
};

// Boundary of the whole space: there is none.
template <typename GeomTraits>
class Boundary<Unbounded_domain_3<GeomTraits>>
{
public:
  static constexpr bool is_bounded = false;

  Boundary() = default;
  explicit Boundary(const Unbounded_domain_3<GeomTraits>&) {}
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_BOUNDARY_H
