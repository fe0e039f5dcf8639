// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_CHECK_CONCEPTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_CHECK_CONCEPTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Compile-time checks of concepts at the entry of a type: a class that is not a model is refused
// with a message that names the concept and the member. Each check returns true.

// Tests whether a use compiles: a generic lambda whose return type is that of the required
// expression.
template <typename... Ts, typename Use>
constexpr bool allows(Use)
{
  return std::is_invocable_v<Use, Ts...>;
}

template <typename T, typename = void>
struct Point_of
{
  using type = void;
};

template <typename T>
struct Point_of<T, std::void_t<typename T::Point_3>>
{
  using type = typename T::Point_3;
};

template <typename Traits>
constexpr bool check_traits()
{
  using P = typename Point_of<Traits>::type;
  static_assert(!std::is_void_v<P>, "CurveFlowTraits_3 requires the type Point_3");
  if constexpr(!std::is_void_v<P>) {
    using T = const Traits&;
    using Q = const P&;
    static_assert(allows<T>([](auto& t) -> typename std::decay_t<decltype(t)>::Vector_3 {}),
                  "CurveFlowTraits_3 requires the type Vector_3");
    static_assert(
        allows<T>([](auto& t) -> decltype(P(t.construct_point_3_object()(0., 0., 0.))) {}),
        "CurveFlowTraits_3 requires construct_point_3_object()");
    static_assert(allows<T, Q>([](auto& t, auto& p) -> decltype(Orientation(
                                                        t.orientation_3_object()(p, p, p, p))) {}),
                  "CurveFlowTraits_3 requires orientation_3_object()");
    static_assert(
        allows<T, Q>([](auto& t, auto& p) -> decltype(Orientation(
                                              t.coplanar_orientation_3_object()(p, p, p))) {}),
        "CurveFlowTraits_3 requires coplanar_orientation_3_object()");
    static_assert(
        allows<T, Q>([](auto& t, auto& p) -> decltype(bool(t.less_xyz_3_object()(p, p))) {}),
        "CurveFlowTraits_3 requires less_xyz_3_object()");
  }
  return true;
}

// Takes the point type of the curves.
template <typename Domain, typename Point_3>
constexpr bool check_domain()
{
  using D = const Domain&;
  using P = const Point_3&;
  static_assert(std::is_same_v<typename Point_of<Domain>::type, Point_3>,
                "VolumeFillingDomain_3 requires the type Point_3, that of the curves");
  static_assert(allows<D>([](auto& d) -> decltype(Bbox_3(d.bbox())) {}),
                "VolumeFillingDomain_3 requires bbox()");
  static_assert(allows<D, P>([](auto& d, auto& p) -> decltype(bool(d.is_inside(p))) {}),
                "VolumeFillingDomain_3 requires is_inside(point)");
  static_assert(
      allows<D, P>([](auto& d, auto& p) -> decltype(bool(d.is_triangle_inside(p, p, p))) {}),
      "VolumeFillingDomain_3 requires is_triangle_inside(point, point, point)");
  static_assert(allows<D, P>([](auto& d, auto& p) -> decltype(double(d.distance(p))) {}),
                "VolumeFillingDomain_3 requires distance(point)");
  static_assert(
      allows<D, P>([](auto& d, auto& p)
                       -> decltype(double(d.distance_along(
                           p, typename std::decay_t<decltype(d)>::Vector_3(0., 0., 0.), 0.))) {}),
      "VolumeFillingDomain_3 requires Vector_3 and distance_along(point, vector, limit)");
  return true;
}

// Takes the type of the flow that the visitor is shown.
template <typename Visitor, typename Flow>
constexpr bool check_visitor()
{
  using V = Visitor&;
  using F = const Flow&;
  static_assert(allows<V, F>([](auto& v, auto& flow) -> decltype(v.on_start(flow), void()) {}),
                "CurveFlowVisitor requires on_start(flow)");
  static_assert(allows<V, F>([](auto& v, auto& flow) -> decltype(v.on_iteration(flow), void()) {}),
                "CurveFlowVisitor requires on_iteration(flow)");
  static_assert(allows<V, F>([](auto& v, auto& flow) -> decltype(bool(v.go_further(flow))) {}),
                "CurveFlowVisitor requires bool go_further(flow)");
  static_assert(allows<V, const Thickness_fit&>(
                    [](auto& v, auto& fit) -> decltype(v.on_thin_domain(fit), void()) {}),
                "CurveFlowVisitor requires on_thin_domain(Thickness_fit)");
  static_assert(allows<V, const Search_progress&>(
                    [](auto& v, auto& progress) -> decltype(bool(v.on_search(progress))) {}),
                "CurveFlowVisitor requires bool on_search(Search_progress)");
  return true;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_CHECK_CONCEPTS_H
