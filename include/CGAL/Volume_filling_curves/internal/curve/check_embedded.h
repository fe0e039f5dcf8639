// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CHECK_EMBEDDED_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CHECK_EMBEDDED_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Squares of lengths must not underflow.
template <typename Network>
void check_size(const Network& curve)
{
  if(curve.number_of_nodes() == 0) return;
  const Vector_field x = coordinates(curve);
  if(!(sides(x).maxCoeff() >= min_extent))
    throw std::invalid_argument("the size of the curve is below 1e-150");
}

// Describes an edge of length zero, or two edges that meet elsewhere than in a common node; returns
// an empty text if the curve is embedded. Exact.
template <typename Network>
std::string first_contact(const Network& curve)
{
  using Traits = typename Network::Traits;
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
      return "the nodes " + names(e) + " of an edge coincide";
  }
  Self_contacts<Traits> contacts(points, edges, curve.traits());
  contacts.find(1);
  if(contacts.count() == 0) return {};
  return "the edge of nodes " + names(contacts.kept()[0][0]) + " meets the edge of nodes " +
         names(contacts.kept()[0][1]);
}

// Throws std::invalid_argument if nothing can be certified of a curve.
template <typename Network>
void check_embedded(const Network& curve)
{
  check_size(curve);
  const std::string contact = first_contact(curve);
  if(!contact.empty()) throw std::invalid_argument(contact);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CHECK_EMBEDDED_H
