// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_IS_DOMAIN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_IS_DOMAIN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Whether a type is that of a domain, and not of a mesh.
template <typename Domain, typename = void>
struct Is_domain : std::false_type
{};

template <typename Domain>
struct Is_domain<Domain,
                 std::void_t<decltype(std::declval<const Domain&>().is_inside(
                     std::declval<const typename Domain::Point_3&>()))>> : std::true_type
{};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_IS_DOMAIN_H
