// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DISTANCE_BOUNDS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DISTANCE_BOUNDS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/domain/distance_up_to.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Lower bounds of the distances of points in a domain from its boundary. Queries of a tree of faces
// are slower far from the surface than near it, and they are many; so distances are kept at the
// centers of the cells of a grid, measured when they are first asked for: the distance changes no
// faster than the point (it is 1-Lipschitz), and only near the boundary, where queries are fast,
// the point itself is measured. Answers do not depend on the order of the questions. Safe in
// parallel.
template <typename Domain>
class Distance_bounds
{
  using Point_3 = typename Domain::Point_3;

public:
  explicit Distance_bounds(const Domain& domain) : m_domain(domain)
  {
    const CGAL::Bbox_3 box = domain.bbox();
    m_low = {box.xmin(), box.ymin(), box.zmin()};
    m_diagonal = (Vector(box.xmax(), box.ymax(), box.zmax()) - m_low).norm();
    m_cell = m_diagonal / cells_along_diagonal;
    for(int i = 0; i < 3; ++i)
      m_size[i] = static_cast<std::size_t>((box.max(i) - box.min(i)) / m_cell) + 1;
    const std::size_t n = m_size[0] * m_size[1] * m_size[2];
    m_distance = std::make_unique<std::atomic<double>[]>(n);
    for(std::size_t k = 0; k < n; ++k) m_distance[k].store(unknown, std::memory_order_relaxed);
  }

  // returns whether x, inside, is known to be farther from the boundary than that
  bool is_farther(const Vector& x, double distance) const
  {
    return conservative(bound_of_cell(x)) > distance;
  }

  // Returns a distance that p = x, inside, is known to have from the boundary: any that is more
  // than `needed`, or else the distance itself, but for rounding errors.
  double operator()(const Point_3& p, const Vector& x, double needed) const
  {
    const double bound = conservative(bound_of_cell(x));
    if(bound > needed) return bound;
    return conservative(distance_up_to(m_domain, p, enough(needed)));
  }

private:
  double conservative(double distance) const { return distance * (1 - slack) - slack * m_diagonal; }

  // a distance that is still more than `needed` when it is taken conservatively
  double enough(double needed) const { return (needed + 2 * slack * m_diagonal) * (1 + 2 * slack); }

  static constexpr double cells_along_diagonal = 64;
  static constexpr double slack = 1e-9; // for the rounding of distances
  static constexpr double unknown = -1;

  double bound_of_cell(const Vector& x) const
  {
    std::size_t k = 0;
    Vector center;
    for(int i = 2; i >= 0; --i) {
      const double place = std::floor((x[i] - m_low[i]) / m_cell);
      const std::size_t last = m_size[i] - 1;
      const std::size_t c =
          !(place > 0) ? 0 : (std::min)(static_cast<std::size_t>((std::min)(place, 1e6)), last);
      k = k * m_size[i] + c;
      center[i] = m_low[i] + (static_cast<double>(c) + 0.5) * m_cell;
    }
    double d = m_distance[k].load(std::memory_order_relaxed);
    if(d == unknown) {
      const Point_3 p(center.x(), center.y(), center.z());
      d = depth(m_domain, p);
      m_distance[k].store(d, std::memory_order_relaxed);
    }
    return d - (x - center).norm();
  }

  const Domain& m_domain;
  Vector m_low;
  double m_diagonal, m_cell;
  std::size_t m_size[3]; // cells along the axes
  std::unique_ptr<std::atomic<double>[]> m_distance;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DISTANCE_BOUNDS_H
