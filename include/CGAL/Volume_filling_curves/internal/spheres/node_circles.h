// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_CIRCLES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_CIRCLES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Circle of directions orthogonal to the curve at a node, for its medial spheres. The first
// direction points to the inside of the bend: the directions rotate with the curve and share its
// symmetry.
struct Node_circle
{
  std::size_t node;
  Vector u, v;  // orthonormal, orthogonal to the tangent
  double share; // of the node's weight; the shares of a node's circles add up to 1

  // Takes a unit tangent and any vector that points to where the curve bends.
  Node_circle(std::size_t n, const Vector& tangent, const Vector& bend, double weight_share)
      : node(n), share(weight_share)
  {
    constexpr double straight = 1e-3; // turning angle below which the first direction is arbitrary
    const Vector normal = bend - bend.dot(tangent) * tangent;
    const double length = normal.norm();
    u = length > straight ? Vector(normal / length) : tangent.unitOrthogonal();
    v = tangent.cross(u);
  }

  Node_circle(std::size_t n, const Vector& tangent, double weight_share)
      : Node_circle(n, tangent, Vector(), weight_share)
  {}

  Vector normal() const { return u.cross(v); } // of its plane, a unit vector
};

// The node's share of the length: half of its edges.
template <typename Network>
std::vector<double> node_weights(const Network& curve, const Vector_field& x)
{
  std::vector<double> weights(curve.number_of_nodes(), 0.);
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const double half = (row(x, curve.target(e)) - row(x, curve.source(e))).norm() / 2;
    weights[curve.source(e)] += half;
    weights[curve.target(e)] += half;
  }
  return weights;
}

// One circle per node inside a curve, orthogonal to the mean of the two edge directions; one per
// edge at ends, junctions and spikes, where there is no such mean, weighted by the edges' lengths.
// The edges may be so short that squares underflow.
// \pre no edge has length zero
template <typename Network>
std::vector<Node_circle> node_circles(const Network& curve, const Vector_field& x)
{
  constexpr double spike = 0.2; // length of the mean direction where the curve turns by 157 degrees
  std::vector<Node_circle> circles;
  circles.reserve(curve.number_of_nodes());
  const auto edge_vector = [&](std::size_t v, std::size_t k) -> Vector {
    return row(x, curve.neighbor(v, k)) - row(x, v);
  };
  const auto direction = [](const Vector& edge) { return in_own_units(edge).normalized(); };
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    const std::size_t degree = curve.degree(v);
    if(degree == 2) {
      const Vector out = direction(edge_vector(v, 1)), back = direction(edge_vector(v, 0));
      const double length = (out - back).norm() / 2;
      if(length > spike) {
        circles.emplace_back(v, (out - back) / (2 * length), out + back, 1.);
        continue;
      }
    }
    double sum = 0;
    for(std::size_t k = 0; k < degree; ++k) sum += stable_norm(edge_vector(v, k));
    for(std::size_t k = 0; k < degree; ++k) {
      const Vector edge = edge_vector(v, k);
      circles.emplace_back(v, direction(edge), stable_norm(edge) / sum);
    }
  }
  return circles;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_CIRCLES_H
