// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_IS_SEQUENCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_IS_SEQUENCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Whether a type is that of a container that grows at its end, such as a vector.
template <typename Object, typename = void>
constexpr bool is_sequence = false;

template <typename Object>
constexpr bool is_sequence<Object,
                           std::void_t<decltype(std::declval<Object&>().push_back(
                               std::declval<typename Object::value_type>()))>> = true;

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_IS_SEQUENCE_H
