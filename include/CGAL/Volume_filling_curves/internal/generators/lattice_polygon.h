// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_LATTICE_POLYGON_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_LATTICE_POLYGON_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_LATTICE_POLYGON_H
