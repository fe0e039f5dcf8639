// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_CHECK_INSIDE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_CHECK_INSIDE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/coverage.h>

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Throws std::invalid_argument, with the nodes in the message, if a curve does not lie strictly
// inside a domain.
template <typename Network, typename Domain>
void check_inside(const Network& curve, const Domain& domain)
{
  const Containment outside = containment(curve, domain);
  if(!outside.outside_nodes.empty())
    throw std::invalid_argument("node " + std::to_string(outside.outside_nodes[0]) +
                                " is not inside the domain");
  if(!outside.outside_edges.empty())
    throw std::invalid_argument("the edge of nodes " +
                                std::to_string(curve.source(outside.outside_edges[0])) + " and " +
                                std::to_string(curve.target(outside.outside_edges[0])) +
                                " meets the boundary of the domain");
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_CHECK_INSIDE_H
