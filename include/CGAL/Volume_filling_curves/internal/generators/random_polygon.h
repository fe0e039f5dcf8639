// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_RANDOM_POLYGON_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_RANDOM_POLYGON_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Turns two edge vectors around their sum by a random angle, which keeps their lengths and the sum.
inline void turn_pair(Vector& u, Vector& v, Random_source& random)
{
  const Vector sum = u + v;
  const auto [c, s] = cos_sin(random.real());
  const double squared = sum.squaredNorm();
  if(squared == 0) { // opposite vectors: any direction will do
    u = random.direction();
    v = -u;
    return;
  }
  const Vector difference = (u - v) / 2; // orthogonal to the sum, since u and v are of equal length
  const Vector turned = c * difference + s * sum.cross(difference) / std::sqrt(squared);
  u = sum / 2 + turned;
  v = sum / 2 - turned;
}

/* returns a random closed polygon with edges of length 1: edge vectors that sum to 0 (pairs of
 * opposite ones, and a triangle if their number is odd) are shuffled, and random pairs are turned
 * around their sum, which mixes them in O(n log n) (the hedgehog method, Klenin et al. 1988;
 * Alvarado, Calvo and Millett 2011). It is embedded with probability 1, and mostly knotted if it
 * has several hundred nodes.
 * \throws std::invalid_argument if there are less than 3 nodes
 */
inline Polygons random_polygon(std::size_t number_of_nodes, std::uint64_t seed)
{
  if(number_of_nodes < 3) throw std::invalid_argument("a polygon needs at least 3 nodes");
  constexpr std::size_t turns_per_edge = 16;
  Random_source random(seed);
  const std::size_t n = number_of_nodes;
  Polygon edges;
  if(n % 2 == 1) {
    const double height = std::sqrt(0.75);
    edges = {Vector(1, 0, 0), Vector(-0.5, height, 0), Vector(-0.5, -height, 0)};
  }
  while(edges.size() < n) {
    edges.push_back(random.direction());
    edges.push_back(-edges.back());
  }
  unsigned calls = 0;
  for(std::size_t k = 0; n > 3 && k < turns_per_edge * n; ++k) {
    check_sometimes(nullptr, calls);
    const std::size_t i = random.index(n), j = random.index(n);
    if(i != j) turn_pair(edges[i], edges[j], random);
  }
  for(std::size_t i = n - 1; i > 0; --i) std::swap(edges[i], edges[random.index(i + 1)]);
  Polygon polygon(1);
  while(polygon.size() < n) polygon.push_back(polygon.back() + edges[polygon.size() - 1]);
  return {polygon};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_RANDOM_POLYGON_H
