// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_HAS_PARTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_HAS_PARTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Whether a domain knows exactly which of its points are connected inside of it, by `part(p)` and
// `part_boxes()`, see `Triangle_mesh_domain_3`.
template <typename Domain, typename = void>
struct Has_parts : std::false_type
{};

template <typename Domain>
struct Has_parts<Domain,
                 std::void_t<decltype(std::declval<const Domain&>().part(
                                 std::declval<const typename Domain::Point_3&>())),
                             decltype(std::declval<const Domain&>().part_boxes())>> : std::true_type
{};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_HAS_PARTS_H
