// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_THINNED_PATHS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_THINNED_PATHS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Paths into regions that are too thin for the required thickness, as points; along them a curve
// may be thinner. Linear in the number of points.
class Thinned_paths
{
public:
  // Takes the distance between neighboring points.
  Thinned_paths(double cell, std::vector<Vector> points) : m_cell(cell), m_points(std::move(points))
  {}

  bool are_empty() const { return m_points.empty(); }

  // The factor of the thickness at a point: `least` on a path, 1 away from it.
  template <typename Point_3>
  double thinning(const Point_3& p, double least) const
  {
    const double reach = ramp * m_cell;
    double nearest = std::numeric_limits<double>::infinity();
    for(const Vector& q : m_points) nearest = (std::min)(nearest, (q - to_vector(p)).squaredNorm());
    const double d = std::sqrt(nearest) / reach;
    return d < 1 ? least : (std::min)(1., least + (1 - least) * (d - 1));
  }

private:
  static constexpr double ramp = 4; // in cells, to either side of a path

  double m_cell;
  std::vector<Vector> m_points;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_THINNED_PATHS_H
