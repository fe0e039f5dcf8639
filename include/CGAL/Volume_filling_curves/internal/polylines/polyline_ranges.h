// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_RANGES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_RANGES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Type traits for functions that take one polyline, a range of polylines, or another type. A point
// may itself be a range of numbers: neither an array of three numbers nor a matrix is a polyline.

template <typename T, typename = void>
struct Range_item
{
  using type = void;
};

template <typename T>
struct Range_item<T,
                  std::void_t<decltype(*std::begin(std::declval<const T&>())),
                              decltype(std::end(std::declval<const T&>()))>>
{
  using type = std::decay_t<decltype(*std::begin(std::declval<const T&>()))>;
};

template <typename T>
using range_item_t = typename Range_item<T>::type;

template <typename T>
inline constexpr bool is_range_of_items =
    !std::is_void_v<range_item_t<T>> && !std::is_arithmetic_v<range_item_t<T>>;

// whether T is a range of polylines
template <typename T>
inline constexpr bool is_range_of_ranges =
    is_range_of_items<T>&& is_range_of_items<range_item_t<T>>;

// the items of polylines: points, or objects that a map converts to points
template <typename T>
using polyline_item_t =
    std::conditional_t<is_range_of_ranges<T>, range_item_t<range_item_t<T>>, range_item_t<T>>;

// The conventions of polylines, from the named parameters of every function that takes polylines.

// the map that gives the points
template <typename Polylines, typename NamedParameters>
auto point_map_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::point_map),
      CGAL::Identity_property_map<polyline_item_t<Polylines>>());
}

template <typename NamedParameters>
Closure closure_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, Volume_filling_curves::internal_np::closure),
      Closure::IF_REPEATED);
}

template <typename NamedParameters>
Junctions junctions_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, Volume_filling_curves::internal_np::junctions),
      Junctions::FORBIDDEN);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_RANGES_H
