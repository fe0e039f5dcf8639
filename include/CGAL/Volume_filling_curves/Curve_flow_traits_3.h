// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_CURVE_FLOW_TRAITS_3_H
#define CGAL_VOLUME_FILLING_CURVES_CURVE_FLOW_TRAITS_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesTraits
 *
 * \brief The class `Curve_flow_traits_3` provides the point type and the exact predicates with which
 * every change of a curve is certified.
 *
 * \tparam Kernel a model of \cgal's `Kernel` with exact predicates, for example
 * `CGAL::Exact_predicates_inexact_constructions_kernel` (default),
 * `CGAL::Exact_predicates_exact_constructions_kernel` or
 * `CGAL::Simple_cartesian<CGAL::Exact_rational>`. A kernel whose predicates are not exact, such as
 * `CGAL::Simple_cartesian<double>`, is refused at compile time, and so is one whose number type does not
 * hold every `double`.
 *
 * \cgalModels{CurveFlowTraits_3}
 */
template <typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
class Curve_flow_traits_3
{
  static_assert(Kernel::Has_filtered_predicates ||
                    Algebraic_structure_traits<typename Kernel::FT>::Is_exact::value,
                "The certificates need a kernel with exact predicates");
  static_assert(
      std::is_same<typename Kernel::FT, double>::value ||
          (Algebraic_structure_traits<typename Kernel::FT>::Is_exact::value &&
           std::is_convertible<
               typename Algebraic_structure_traits<typename Kernel::FT>::Algebraic_category,
               Field_tag>::value),
      "The certificates need points whose coordinates can be any double, unrounded");

public:
  /// \name Types
  /// @{

  /// the kernel's point type
  using Point_3 = typename Kernel::Point_3;

  /// constructs a point from its coordinates
  using Construct_point_3 = typename Kernel::Construct_point_3;

  /// the orientation of four points
  using Orientation_3 = typename Kernel::Orientation_3;

  /// the orientation of three points in their plane
  using Coplanar_orientation_3 = typename Kernel::Coplanar_orientation_3;

  /// the lexicographic order of points
  using Less_xyz_3 = typename Kernel::Less_xyz_3;

  /// @}

  /// \name Operations
  /// @{

  /// constructs the traits from a kernel object.
  explicit Curve_flow_traits_3(const Kernel& kernel = Kernel()) : m_kernel(kernel) {}

  /// returns the functor that constructs a point from three coordinates of type `double`.
  Construct_point_3 construct_point_3_object() const { return m_kernel.construct_point_3_object(); }

  /// returns the predicate for the orientation of four points.
  Orientation_3 orientation_3_object() const { return m_kernel.orientation_3_object(); }

  /// returns the predicate for the orientation of three points in their plane.
  Coplanar_orientation_3 coplanar_orientation_3_object() const
  {
    return m_kernel.coplanar_orientation_3_object();
  }

  /// returns the predicate that compares points lexicographically.
  Less_xyz_3 less_xyz_3_object() const { return m_kernel.less_xyz_3_object(); }

  /// @}

private:
  Kernel m_kernel;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_CURVE_FLOW_TRAITS_3_H
