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

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Closed axis-parallel box, empty by default.
class Box
{
public:
  Box() = default;
  explicit Box(const Vector& p) : m_min(p), m_max(p) {}
  Box(const Vector& min, const Vector& max) : m_min(min), m_max(max) {}

  const Vector& min() const { return m_min; }
  const Vector& max() const { return m_max; }
  Vector sizes() const { return m_max - m_min; }

  Box& extend(const Vector& p)
  {
    m_min = m_min.cwiseMin(p);
    m_max = m_max.cwiseMax(p);
    return *this;
  }

  Box& extend(const Box& box)
  {
    m_min = m_min.cwiseMin(box.m_min);
    m_max = m_max.cwiseMax(box.m_max);
    return *this;
  }

  bool intersects(const Box& box) const
  {
    for(int k = 0; k < 3; ++k)
      if(m_min[k] > box.m_max[k] || box.m_min[k] > m_max[k]) return false;
    return true;
  }

private:
  static constexpr double most = (std::numeric_limits<double>::max)();

  Vector m_min = Vector::constant(most), m_max = Vector::constant(-most);
};

inline Box inflated(const Box& box, double distance)
{
  const Vector margin = Vector::constant(distance);
  return {box.min() - margin, box.max() + margin};
}

inline Bbox_3 to_bbox(const Box& box)
{
  const Vector &low = box.min(), &high = box.max();
  return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
}

// returns the squared distance of two boxes, 0 if they overlap
inline double squared_distance_of_boxes(const Bbox_3& a, const Bbox_3& b)
{
  double sum = 0;
  for(int i = 0; i < 3; ++i) {
    const double gap = (std::max)({a.min(i) - b.max(i), b.min(i) - a.max(i), 0.});
    sum += gap * gap;
  }
  return sum;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_BOX_H
