// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_CGAL_COMPATIBILITY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_CGAL_COMPATIBILITY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/version.h>

// All differences between CGAL 5.5 and 6.x that this package meets.

#if CGAL_VERSION_NR >= 1060000900
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#include <optional>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <boost/optional.hpp>
#endif

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

#if CGAL_VERSION_NR >= 1060000900
template <typename Kernel, typename Iterator>
using Aabb_triangle_primitive = CGAL::AABB_triangle_primitive_3<Kernel, Iterator>;
template <typename Kernel, typename Primitive>
using Aabb_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
template <typename T>
using Optional = std::optional<T>;
#else
template <typename Kernel, typename Iterator>
using Aabb_triangle_primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
template <typename Kernel, typename Primitive>
using Aabb_traits = CGAL::AABB_traits<Kernel, Primitive>;
template <typename T>
using Optional = boost::optional<T>;
#endif

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_CGAL_COMPATIBILITY_H
