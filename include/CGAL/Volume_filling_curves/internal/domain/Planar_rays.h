// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_PLANAR_RAYS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_PLANAR_RAYS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Rays from a point in directions of a plane, each with a length, in one array per coordinate.
struct Planar_rays
{
  Vector source, normal;
  std::vector<double> x, y, z; // of the directions, unit vectors orthogonal to the normal
  std::vector<double> lengths; // 0 for rays that do not matter

  std::size_t size() const { return lengths.size(); }
  double longest() const { return *std::max_element(lengths.begin(), lengths.end()); }
  Vector direction(std::size_t l) const { return {x[l], y[l], z[l]}; }

  void set_direction(std::size_t l, const Vector& direction)
  {
    for(auto* values : {&x, &y, &z}) values->resize(size());
    x[l] = direction.x();
    y[l] = direction.y();
    z[l] = direction.z();
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_PLANAR_RAYS_H
