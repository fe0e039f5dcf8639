// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BOX_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BOX_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>

#include <Eigen/Geometry>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// An axis-parallel box, closed; empty by default.
using Box = Eigen::AlignedBox3d;

inline Box inflated(const Box& box, double distance)
{
  return {box.min().array() - distance, box.max().array() + distance};
}

inline Bbox_3 to_bbox(const Box& box)
{
  const Vector &low = box.min(), &high = box.max();
  return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BOX_H
