// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BOX_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BOX_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Vector.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// An axis-parallel box, closed.
struct Box
{
  Vector min, max;

  static Box of(const Vector& p) { return {p, p}; }

  Box& operator+=(const Vector& p)
  {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
    return *this;
  }

  Box inflated(double distance) const { return {min.array() - distance, max.array() + distance}; }

  double longest_side() const { return (max - min).maxCoeff(); }
};

inline bool do_overlap(const Box& a, const Box& b)
{
  return a.min.x() <= b.max.x() && b.min.x() <= a.max.x() && a.min.y() <= b.max.y() &&
         b.min.y() <= a.max.y() && a.min.z() <= b.max.z() && b.min.z() <= a.max.z();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BOX_H
