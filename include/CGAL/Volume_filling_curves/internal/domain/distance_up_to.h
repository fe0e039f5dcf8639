// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DISTANCE_UP_TO_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DISTANCE_UP_TO_H

#include <CGAL/license/Volume_filling_curves.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Whether a domain knows the distances to its boundary, not only lower bounds of them, and ends
// the search for one at a limit, see `Triangle_mesh_domain_3`.
template <typename Domain, typename = void>
struct Has_distance_up_to : std::false_type
{};

template <typename Domain>
struct Has_distance_up_to<Domain,
                          std::void_t<decltype(std::declval<const Domain&>().distance_up_to(
                              std::declval<const typename Domain::Point_3&>(), double()))>>
    : std::true_type
{};

// returns the distance to the boundary, or the limit if the domain finds out that it is less
template <typename Domain>
double distance_up_to(const Domain& domain,
                      const typename Domain::Point_3& p,
                      [[maybe_unused]] double limit)
{
  if constexpr(Has_distance_up_to<Domain>::value)
    return domain.distance_up_to(p, limit);
  else
    return domain.distance(p);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DISTANCE_UP_TO_H
