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

namespace internal {

// Requirements on a kernel: exact predicates, and coordinates that hold every double: double, or an
// exact field, which holds all rationals.
template <typename Kernel>
struct Is_exact_kernel
{
  using Number = Algebraic_structure_traits<typename Kernel::FT>;

  static constexpr bool has_exact_predicates =
      Kernel::Has_filtered_predicates || Number::Is_exact::value;
  static constexpr bool holds_doubles =
      std::is_same_v<typename Kernel::FT, double> ||
      (Number::Is_exact::value &&
       std::is_convertible_v<typename Number::Algebraic_category, Field_tag>);
};

template <typename Traits, typename = void>
struct Is_kernel : std::false_type
{};

template <typename Traits>
struct Is_kernel<
    Traits,
    std::void_t<typename Traits::Has_filtered_predicates_tag, typename Traits::Kernel_tag>>
    : std::true_type
{};

// Exactness is checked for a kernel; a traits class guarantees it by its concept.
template <typename Traits>
constexpr bool can_certify()
{
  if constexpr(Is_kernel<Traits>::value)
    return Is_exact_kernel<Traits>::has_exact_predicates && Is_exact_kernel<Traits>::holds_doubles;
  else
    return true;
}

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesTraits
 *
 * \brief The class `Curve_flow_traits_3` provides the point type and the exact predicates that
 * certify every change of a curve.
 *
 * A kernel with exact predicates is a traits class itself, as in
 * `Curve_network_3<CGAL::Exact_predicates_inexact_constructions_kernel>`.
 *
 * \tparam Kernel a model of \cgal's `Kernel` with exact predicates, for example
 * `CGAL::Exact_predicates_inexact_constructions_kernel` (default),
 * `CGAL::Exact_predicates_exact_constructions_kernel` or
 * `CGAL::Simple_cartesian<CGAL::Exact_rational>`. A kernel whose predicates are not exact, such as
 * `CGAL::Simple_cartesian<double>`, is refused at compile time, and so is one whose number type
 * does not hold every `double`.
 *
 * \cgalModels{CurveFlowTraits_3}
 */
template <typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
class Curve_flow_traits_3
{
  static_assert(internal::Is_exact_kernel<Kernel>::has_exact_predicates,
                "The certificates need a kernel with exact predicates, such as "
                "Exact_predicates_inexact_constructions_kernel; polylines of other points need a "
                "point_map whose value type is a point of such a kernel");
  static_assert(internal::Is_exact_kernel<Kernel>::holds_doubles,
                "The certificates need points whose coordinates can be any double, unrounded");

public:
  /// \name Types
  /// @{

  /// the kernel's point type
  using Point_3 = typename Kernel::Point_3;

  /// the kernel's vector type
  using Vector_3 = typename Kernel::Vector_3;

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
