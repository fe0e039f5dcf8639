// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_COORDINATE_RANGE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_COORDINATE_RANGE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Range of the coordinates that networks, readers, domains and guards accept, and least size of the
// bounding box of a curve that moves: squares of lengths neither overflow nor underflow.
constexpr double max_coordinate = 1e150, min_extent = 1e-150;

// returns whether all coordinates are accepted; NaN is not
inline bool is_in_range(const Vector& x)
{
  for(int k = 0; k < 3; ++k)
    if(!(std::abs(x[k]) <= max_coordinate)) return false;
  return true;
}

// Throws std::invalid_argument, with `name` in the message, unless the coordinates are accepted.
inline void check_range(const Vector& x, const std::string& name)
{
  if(!x.allFinite()) throw std::invalid_argument(name + " is not finite");
  if(!is_in_range(x)) throw std::invalid_argument(name + " has a coordinate beyond 1e150");
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_COORDINATE_RANGE_H
