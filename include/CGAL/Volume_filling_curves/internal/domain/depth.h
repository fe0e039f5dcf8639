// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_H

#include <CGAL/license/Volume_filling_curves.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The distance of a point inside a domain from the boundary, 0 outside.
template <typename Domain>
double depth(const Domain& domain, const typename Domain::Point_3& p)
{
  return domain.is_inside(p) ? domain.distance(p) : 0;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DEPTH_H
