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
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// How a filling starts.
enum class Filling_start
{
  TREE,  ///< with fingers through the whole domain, see `grow_fingers()`
  CIRCLE ///< without fingers: the curve, or a small circle, grows as in the paper
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The struct `Port` is a point at the boundary of a domain where a filling enters it.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3 = Curve_flow_traits_3<>::Point_3>
struct Port
{
  /// The point, on the boundary or within r of it.
  Point_3 point;

  /// The direction, of any length, in which the curve enters, hence crosses the boundary from
  /// outside. Zero (default) stands for the inward normal.
  std::array<double, 3> direction = {0, 0, 0};
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The parameters of `fill()`.
 *
 * Some parameters of the flow change during the run:
 *
 * - `screening` is multiplied by 30 while the curve opens or grows.
 * - `max_radius` (default 6) limits the speed of the growth from a circle; it is at most 3 while
 *   fingers open, and at most 2 at the end.
 * - `max_displacement` (default 1) is at most 0.5 while a curve grows, and shrinks at the end.
 * - `number_of_directions` is at most 8, and 2 while bends are rounded.
 *
 * Without `round_bends`, `screening` is multiplied by 3 while the curve settles,
 * `max_displacement` shrinks from at most 0.6 then, and the last steps use the full
 * `number_of_directions`. With the default `medial_weight` of 3.15^2, the curve then settles with a
 * mean medial radius of r.
 *
 * The default `thickness` is a quarter of the radius of the widest ball inside. If the curve would
 * then have more than about 200,000 nodes, the thickness with about 200,000 nodes is used, but at
 * most the radius of that ball. If a `length` is given, the thickness is computed from it.
 *
 * Each member, including those of the base classes, can be set by the named parameter of the same
 * name; the named parameter `thickness` also takes a function, which sets `thickness_field`.
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

  /// How the filling starts, from the given curves or from circles.
  Filling_start start = Filling_start::TREE;

  /// A thickness that varies in space, instead of `thickness`: a function of the point. It must be
  /// positive, finite and not larger than the domain everywhere in the domain's box, and safe to
  /// call concurrently. None by default.
  std::function<double(const Point_3&)> thickness_field;

  /// The distance from the boundary that the whole curve keeps, apart from the necks of ports, in
  /// the input's unit: certified like containment. The curve still covers the domain as well as it
  /// can from there; points nearer to the boundary than that do not count in
  /// `Filling_result::unfilled_fraction`. A node that a constraint keeps nearer to the boundary is
  /// refused. 0 (default) stands for none.
  double wall_distance = 0;

  /// A direction field for the curve to follow: a function of the point that returns a vector, a
  /// `std::array<double, 3>` or any type with members `x()`, `y()` and `z()`. Neither its sign nor
  /// its length matters; zero stands for no preference. It must be finite and safe to call
  /// concurrently. None by default.
  std::function<internal::Field_vector(const Point_3&)> direction_field;

  /// The weight w of a `direction_field`, dimensionless: in the energy, length perpendicular to the
  /// field counts 1 + w times as much as length parallel to it, and 1 + 4 w times as much while the
  /// curve opens or grows. With the default and without `round_bends`, bunny and cube reach an
  /// `alignment()` of 0.75 and the same coverage as without a field, with a curve that is an eighth
  /// longer; with round bends a cube reaches 0.55 to 0.64. With 0.4 the alignment of the former is
  /// 0.8 and the curve a fifth longer, and gaps of 2.5 r may remain where strands turn.
  double direction_weight = 0.2;

  /// The points where the curves enter the domain, if no curves are given: an even number of them.
  /// An arc leads from each odd port to the next one. At a port the curve is straight for a length
  /// of r, or of `wall_distance` + r/2 if that is more, but at most for half of the width of the
  /// domain there, see `Filling_result::necks`. None by default.
  std::vector<Port<Point_3>> ports;

  /// The shares of the volume for the components of the curve, such as the arcs between ports: a
  /// positive number for each, in the order of the components, which for arcs is that of their
  /// ports. Only their ratios matter. The tree of fingers always grows from the component with the
  /// least volume per share; a component that others enclose ends with less, and components in
  /// different parts of the domain do not share. Requires `Filling_start::TREE`. Empty (default)
  /// stands for equal shares.
  std::vector<double> volume_shares;

  /// The required length of the result, reached within 2 %, in the input's unit, instead of a
  /// thickness. 0 (default) stands for none.
  double length = 0;

  /// The least radius with which the curve may bend, in the input's unit: that of the arcs that
  /// round the corners, see `min_bend_radius()`. 0 (default) stands for 0.85 r, where r may vary in
  /// space. Where r is less than `bend_radius`, it grows to it: no denser curve has room for its
  /// bends.
  double bend_radius = 0;

  /// The least distance between strands, in the input's unit: of edges with at least half of a turn
  /// of curve between them, pi times `bend_radius`, or pi/2 times the distance if that is more. 0
  /// (default) stands for 1.6 r. Where r is less than this distance / 1.8, it grows to that.
  double strand_distance = 0;

  /// Whether the curve keeps a bend radius and a distance between strands, with edges of at least
  /// 0.3 r; `true` by default. Where it cannot, the run ends as
  /// `Filling_status::CONSTRAINT_NOT_REACHED`. `false` is for previews: bend radii are then about
  /// 0.15 r, and a run takes 0.3 to 0.7 of the time; a `bend_radius` or `strand_distance` that is
  /// given holds nevertheless.
  bool round_bends = true;
};

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
  /// The thickness r of the filling, in the input's unit. It must be given, since 0 is refused.
  double thickness = 0;

  /// A thickness that varies in space, instead of `thickness`: a function of the point, which must
  /// be positive and finite. None by default.
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

  /// The time limit, in seconds, at which no further fingers grow. Infinite by default.
  double time_limit = std::numeric_limits<double>::infinity();

  /// Is called every few milliseconds, like `Curve_run_parameters::progress`; if it returns
  /// `false`, no further fingers grow.
  std::function<bool(const Run_progress&)> progress;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_FILLING_PARAMETERS_H
