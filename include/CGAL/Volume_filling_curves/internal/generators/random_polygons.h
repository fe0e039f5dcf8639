// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_RANDOM_POLYGONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_RANDOM_POLYGONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Random closed polygons: with edges of length 1 in any direction, and on the cubic lattice, always
// unknotted.

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
    check_run_sometimes(calls);
    const std::size_t i = random.index(n), j = random.index(n);
    if(i != j) turn_pair(edges[i], edges[j], random);
  }
  for(std::size_t i = n - 1; i > 0; --i) std::swap(edges[i], edges[random.index(i + 1)]);
  Polygon polygon(1);
  while(polygon.size() < n) polygon.push_back(polygon.back() + edges[polygon.size() - 1]);
  return {polygon};
}

// Random self-avoiding polygon on the cubic lattice, grown from a unit square: a random edge is
// pushed sideways by one unit if both new sites are free (the growing move of Berg, Foerster,
// Aragao de Carvalho, Caracciolo and Froehlich, 1981-83). Every move is an isotopy, so the polygon
// is an unknot. Its nodes, edges and planes coincide in all ways that break arithmetic with
// doubles. Expected time O(n log n).
class Lattice_polygon
{
public:
  explicit Lattice_polygon(std::uint64_t seed) : m_random(seed)
  {
    for(const Site& site : {Site{0, 0, 0}, Site{1, 0, 0}, Site{1, 1, 0}, Site{0, 1, 0}}) add(site);
    m_next = {1, 2, 3, 0};
  }

  // \pre the number of nodes is even and at least 4
  Polygon operator()(std::size_t number_of_nodes)
  {
    while(m_sites.size() < number_of_nodes) push_edge(m_random.index(m_sites.size()));
    Polygon polygon;
    std::size_t i = 0;
    do {
      const Site& site = m_sites[i];
      polygon.emplace_back(site[0], site[1], site[2]);
      i = m_next[i];
    } while(i != 0);
    return polygon;
  }

private:
  using Site = std::array<int, 3>;

  void add(const Site& site)
  {
    m_sites.push_back(site);
    m_is_taken.insert(site);
  }

  void push_edge(std::size_t i)
  {
    const std::size_t j = m_next[i], axis = m_random.index(3);
    const int step = m_random.index(2) == 0 ? 1 : -1;
    Site first = m_sites[i], second = m_sites[j];
    if(first[axis] != second[axis]) return;
    first[axis] += step;
    second[axis] += step;
    if(m_is_taken.count(first) + m_is_taken.count(second) > 0) return;
    const std::size_t new_first = m_sites.size();
    add(first);
    add(second);
    m_next[i] = new_first;
    m_next.push_back(new_first + 1);
    m_next.push_back(j);
  }

  Random_source m_random;
  std::vector<Site> m_sites;
  std::vector<std::size_t> m_next;
  std::set<Site> m_is_taken;
};

// Returns a random polygon on the cubic lattice, an unknot, see `Lattice_polygon`.
// \throws std::invalid_argument if the number of nodes is odd or less than 4
inline Polygons lattice_polygon(std::size_t number_of_nodes, std::uint64_t seed)
{
  if(number_of_nodes < 4 || number_of_nodes % 2 == 1)
    throw std::invalid_argument("a lattice polygon needs an even number of nodes, 4 or more");
  return {Lattice_polygon(seed)(number_of_nodes)};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_RANDOM_POLYGONS_H
