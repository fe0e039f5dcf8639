// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_EMBEDDED_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_EMBEDDED_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/Vector.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Squares of lengths must not overflow or underflow.
template <typename Network>
void check_size(const Network& curve)
{
  constexpr double largest_coordinate = 1e150, least_size = 1e-150;
  if(curve.number_of_nodes() == 0) return;
  const Vector_field x = coordinates(curve);
  if(!(x.cwiseAbs().maxCoeff() <= largest_coordinate))
    throw std::invalid_argument("a coordinate is beyond 1e150");
  if(!((x.colwise().maxCoeff() - x.colwise().minCoeff()).maxCoeff() >= least_size))
    throw std::invalid_argument("the size of the curve is below 1e-150");
}

// Throws std::invalid_argument if two edges meet elsewhere than in a common node, or an edge has
// length zero: nothing can be certified of such a curve. Exact.
template <typename Network>
void check_embedded(const Network& curve)
{
  using Traits = typename Network::Traits;
  check_size(curve);
  std::vector<typename Traits::Point_3> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) points.push_back(curve.point(v));
  const auto names = [&](std::size_t e) {
    return std::to_string(curve.source(e)) + " and " + std::to_string(curve.target(e));
  };
  const Exact_predicates<Traits> predicates(curve.traits());
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    edges.push_back({curve.source(e), curve.target(e)});
    if(predicates.are_equal(points[edges[e][0]], points[edges[e][1]]))
      throw std::invalid_argument("the nodes " + names(e) + " of an edge coincide");
  }
  Self_contacts<Traits> contacts(points, edges, curve.traits());
  contacts.find(1);
  if(contacts.count() > 0)
    throw std::invalid_argument("the edge of nodes " + names(contacts.kept()[0][0]) +
                                " meets the edge of nodes " + names(contacts.kept()[0][1]));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_EMBEDDED_H
