// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FIELD_VECTOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FIELD_VECTOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/number_utils.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Result of a user's direction field: three numbers, converted from an array or from any vector
// with members x(), y() and z(), such as CGAL's or Eigen's.
struct Field_vector : std::array<double, 3>
{
  using Array = std::array<double, 3>;

  template <typename Vector_3, typename = decltype(std::declval<const Vector_3&>().z())>
  static Array to_array(const Vector_3& v, int)
  {
    return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
  }

  static Array to_array(const Array& v, ...) { return v; }

  // from any argument of to_array()
  template <typename Vector_3, typename = decltype(to_array(std::declval<const Vector_3&>(), 0))>
  Field_vector(const Vector_3& v) : Array(to_array(v, 0))
  {}
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FIELD_VECTOR_H
