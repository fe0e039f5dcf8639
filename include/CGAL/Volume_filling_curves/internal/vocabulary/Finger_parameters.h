// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FINGER_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FINGER_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Field_vector.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <cstddef>
#include <functional>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The parameters of `grow_fingers()`.
 *
 * Each member can be set by the named parameter of the same name; the named parameter `thickness`
 * also takes a function, which sets `thickness_field`.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3 = Curve_flow_traits_3<>::Point_3>
struct Finger_parameters
{
  /// The thickness r of the filling, in the input's unit. There is no default.
  double thickness = 0;

  /// A thickness that varies in space, instead of `thickness`: a function of the point, which must
  /// be positive. None by default.
  std::function<double(const Point_3&)> thickness_field;

  /// A direction field for the fingers to follow: a function of the point that returns a vector, a
  /// `std::array<double, 3>` or any type with members `x()`, `y()` and `z()`. Neither its sign nor
  /// its length matters; zero stands for no preference. It must be finite. None by default.
  std::function<internal::Field_vector(const Point_3&)> direction_field;

  /// The weight of a `direction_field`, dimensionless, as in `Filling_parameters`: among points at
  /// the same distance, the tree prefers those along the field.
  double direction_weight = 0.2;

  /// The seed of the points and of the tree.
  std::size_t random_seed = 0;

  /// The time limit, in seconds. Infinite by default.
  double time_limit = std::numeric_limits<double>::infinity();

  /// Is called every few milliseconds, like `Curve_run_parameters::progress`; if it returns
  /// `false`, no further fingers grow.
  std::function<bool(const Run_progress&)> progress;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FINGER_PARAMETERS_H
