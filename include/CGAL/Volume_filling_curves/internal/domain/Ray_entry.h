// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_RAY_ENTRY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_RAY_ENTRY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Entry point of a ray into a box, by clipping with three pairs of planes (the slab method; Kay and
// Kajiya 1986). The boxes are widened by the rounding error, which ensures that nothing inside is
// missed.
class Ray_entry
{
public:
  // Takes the largest absolute value of a coordinate of the boxes.
  Ray_entry(const Vector& p, const Vector& u, double largest)
      : m_p(p),
        m_margin(8 * std::numeric_limits<double>::epsilon() *
                 (std::max)(largest, p.cwiseAbs().maxCoeff()))
  {
    for(int i = 0; i < 3; ++i) m_inverse[i] = 1 / (std::abs(u[i]) > tiny ? u[i] : tiny);
  }

  // returns the least t in [0, limit] for which p + t u is in the box, infinity if there is none
  double operator()(const Bbox_3& box, double limit) const
  {
    double first = 0, last = limit;
    clip(box.xmin(), box.xmax(), 0, first, last);
    clip(box.ymin(), box.ymax(), 1, first, last);
    clip(box.zmin(), box.zmax(), 2, first, last);
    return first <= last ? first : std::numeric_limits<double>::infinity();
  }

private:
  static constexpr double tiny = 1e-150; // components of the direction below count as zero

  void clip(double low, double high, int axis, double& first, double& last) const
  {
    const double to_low = (low - m_margin - m_p[axis]) * m_inverse[axis];
    const double to_high = (high + m_margin - m_p[axis]) * m_inverse[axis];
    first = (std::max)(first, (std::min)(to_low, to_high));
    last = (std::min)(last, (std::max)(to_low, to_high));
  }

  Vector m_p, m_inverse;
  double m_margin;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_RAY_ENTRY_H
