// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_INSIDE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_INSIDE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Throws std::invalid_argument, with the nodes in the message, if a curve does not lie strictly inside
// a domain.
template <typename Network, typename Domain>
void check_inside(const Network& curve, const Domain& domain)
{
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(!domain.is_inside(curve.point(v)))
      throw std::invalid_argument("node " + std::to_string(v) + " is not inside the domain");
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const std::size_t v = curve.source(e), w = curve.target(e);
    if(!domain.is_triangle_inside(curve.point(v), curve.point(w), curve.point(w)))
      throw std::invalid_argument("the edge of nodes " + std::to_string(v) + " and " +
                                  std::to_string(w) + " meets the boundary of the domain");
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_INSIDE_H
