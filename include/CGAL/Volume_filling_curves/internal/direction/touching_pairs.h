// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_TOUCHING_PAIRS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_TOUCHING_PAIRS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A pair of nodes of which one touches a medial sphere of the other, with the least such radius.
struct Touching_pair
{
  Medial_spheres::Index low, high;
  double radius;
};

// Adds the pairs of a circle's node, each once.
inline void add_touching_pairs(const Medial_spheres& spheres,
                               std::size_t c,
                               std::vector<Touching_pair>& pairs)
{
  const auto first = static_cast<std::ptrdiff_t>(pairs.size());
  const auto node = static_cast<Medial_spheres::Index>(spheres.circles()[c].node);
  for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
    const auto other = spheres.touching_node(c, l);
    if(other == Medial_spheres::no_node) continue;
    const Touching_pair pair = {(std::min)(node, other), (std::max)(node, other),
                                spheres.radius(c, l)};
    const auto known = std::find_if(pairs.begin() + first, pairs.end(), [&](const auto& p) {
      return p.low == pair.low && p.high == pair.high;
    });
    if(known == pairs.end())
      pairs.push_back(pair);
    else
      known->radius = (std::min)(known->radius, pair.radius);
  }
}

// Sorts by the lower nodes first: a node has a few pairs only, so that counting beats comparing.
inline std::vector<Touching_pair> sorted_by_lower_node(const std::vector<Touching_pair>& pairs,
                                                       std::size_t number_of_nodes)
{
  std::vector<std::size_t> place(number_of_nodes + 1, 0);
  for(const Touching_pair& pair : pairs) ++place[pair.low + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<Touching_pair> sorted(pairs.size());
  for(const Touching_pair& pair : pairs) sorted[place[pair.low]++] = pair;
  return sorted;
}

// Each pair once, whichever node's spheres it comes from, ordered by its nodes. Linear.
inline std::vector<Touching_pair> touching_pairs(const Medial_spheres& spheres,
                                                 std::size_t number_of_nodes)
{
  std::vector<Touching_pair> found;
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) add_touching_pairs(spheres, c, found);
  std::vector<Touching_pair> pairs = sorted_by_lower_node(found, number_of_nodes);
  const auto is_less = [](const Touching_pair& a, const Touching_pair& b) {
    return a.high != b.high ? a.high < b.high : a.radius < b.radius;
  };
  for(auto begin = pairs.begin(); begin != pairs.end();) {
    const auto end = std::find_if(
        begin, pairs.end(), [&](const Touching_pair& pair) { return pair.low != begin->low; });
    std::sort(begin, end, is_less);
    begin = end;
  }
  const auto is_same = [](const Touching_pair& a, const Touching_pair& b) {
    return a.low == b.low && a.high == b.high;
  };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), is_same), pairs.end());
  return pairs;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_TOUCHING_PAIRS_H
