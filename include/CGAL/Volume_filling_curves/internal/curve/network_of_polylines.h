// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_OF_POLYLINES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_OF_POLYLINES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>

#include <CGAL/Kernel_traits.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Test whether a point type belongs to a kernel.
template <typename Point, typename = void>
struct Is_kernel_point : std::false_type
{};

template <typename Point>
struct Is_kernel_point<Point, std::void_t<typename Kernel_traits<Point>::Kernel::Point_3>>
    : std::true_type
{};

// The network that polylines become, with the kernel of their points.
template <typename Polylines, typename NamedParameters>
struct Network_of_polylines
{
  using Point_map = decltype(point_map_of<Polylines>(std::declval<NamedParameters>()));
  using Point_3 = std::decay_t<decltype(get(std::declval<Point_map>(),
                                            std::declval<const polyline_item_t<Polylines>&>()))>;

  static_assert(Is_kernel_point<Point_3>::value,
                "Points of polylines must be those of a kernel of CGAL; items of another type need "
                "a point_map that reads and writes them as such points");

  using type = Curve_network_3<Curve_flow_traits_3<typename Kernel_traits<Point_3>::Kernel>>;
};

template <typename Polylines, typename NamedParameters>
using network_of_polylines_t = typename Network_of_polylines<Polylines, NamedParameters>::type;

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_OF_POLYLINES_H
