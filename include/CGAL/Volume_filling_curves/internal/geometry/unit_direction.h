// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_UNIT_DIRECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_UNIT_DIRECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Field_vector.h>

#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Direction of a field at a point, as a unit vector, or zero if there is no preference. Throws
// std::invalid_argument, with the point in the message, if the field is not finite.
template <typename Field, typename Point_3>
Vector unit_direction(const Field& field, const Point_3& p)
{
  const Field_vector given = field(p);
  const Vector v(given[0], given[1], given[2]);
  if(!v.allFinite())
    throw std::invalid_argument("direction_field is not finite at " + point_text(p));
  const double size = v.cwiseAbs().maxCoeff(); // squares must neither overflow nor underflow
  return size > 0 ? (v / size).normalized() : Vector();
}

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_UNIT_DIRECTION_H
