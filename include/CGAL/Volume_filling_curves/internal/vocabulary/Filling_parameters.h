// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FILLING_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FILLING_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Field_vector.h>

#include <functional>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// How a curve that is to fill a domain sets out.
enum class Filling_start
{
  TREE,  ///< fingers reach out all over the domain at once, see `grow_fingers()`
  CIRCLE ///< it grows from what it is, as in the paper, where that is a small circle
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The parameters of `fill()`.
 *
 * Of the flow's some are not the same from the start to the end. While the curve opens or grows,
 * `screening` is 30 times larger, 3 times when it settles; `max_radius`, whose default is 6 here,
 * is at most 3 while fingers open, the speed of the growth from a circle, and at most 2 in the end;
 * `max_displacement`, whose default is 1 here, is at most 0.5 while a curve grows, and shrinks from
 * at most 0.6 in the end; `number_of_directions` is at most 8 but for the last steps. With a
 * `medial_weight` of 3.15^2, the default here, the curve settles with a mean medial radius of r.
 *
 * The default of the `thickness` is a quarter of the radius of the widest ball inside, or the one
 * with which the curve has some 200,000 nodes if that is larger, but at most that radius. With a
 * `length` the thickness is the one that leads to it.
 *
 * Each member, those of the base classes included, can be set by the named parameter of the same
 * name; the named parameter `thickness` takes a function, too, and sets `thickness_field` then.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3 = Curve_flow_traits_3<>::Point_3>
struct Filling_parameters : Curve_run_parameters
{
  Filling_parameters()
  {
    medial_weight = 3.15 * 3.15;
    max_radius = 6; // 12 is as fast on the bunny
    max_displacement = 1;
  }

  /// How the curve sets out, be it given or a circle.
  Filling_start start = Filling_start::TREE;

  /// A thickness that varies in space, instead of `thickness`: a function of the point. It must be
  /// positive, finite and no larger than the domain, everywhere in the domain's box, and safe to
  /// call concurrently. None by default.
  std::function<double(const Point_3&)> thickness_field;

  /// A direction field that the curve is to follow: a function of the point that returns a vector,
  /// a `std::array<double, 3>` or any type with members `x()`, `y()` and `z()`. Neither its sign
  /// nor its length matters; zero stands for no preference. It must be finite and safe to call
  /// concurrently. None by default.
  std::function<internal::Field_vector(const Point_3&)> direction_field;

  /// The weight of a `direction_field`, dimensionless: length across it counts 1 +
  /// `direction_weight` times as much in the energy as length along it, four times that much more
  /// while the curve opens or grows. With the default bunny and cube end with an alignment of 0.75
  /// (see `alignment()`) and covered as without a field, by a curve that is an eighth longer; with
  /// 0.4 it is 0.8, a fifth longer, and gaps of 2.5 r may stay where strands turn.
  double direction_weight = 0.2;

  /// The length that the result is to have, within 2 %, in the input's unit, instead of a
  /// thickness. 0 (default) stands for none.
  double length = 0;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FILLING_PARAMETERS_H
