// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TOUCHING_PAIRS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TOUCHING_PAIRS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Medial_spheres.h>

#include <algorithm>
#include <array>
#include <cstddef>
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

// Each pair once, whichever node's spheres it comes from, ordered by its nodes.
inline std::vector<Touching_pair> touching_pairs(const Medial_spheres& spheres)
{
  std::vector<Touching_pair> pairs;
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    const auto node = static_cast<Medial_spheres::Index>(spheres.circles()[c].node);
    const std::size_t first_of_circle = pairs.size();
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      const auto other = spheres.touching_node(c, l);
      if(other == Medial_spheres::no_node) continue;
      const Touching_pair pair = {(std::min)(node, other), (std::max)(node, other),
                                  spheres.radius(c, l)};
      const auto known = std::find_if(
          pairs.begin() + static_cast<std::ptrdiff_t>(first_of_circle), pairs.end(),
          [&](const Touching_pair& p) { return p.low == pair.low && p.high == pair.high; });
      if(known == pairs.end())
        pairs.push_back(pair);
      else
        known->radius = (std::min)(known->radius, pair.radius);
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Touching_pair& a, const Touching_pair& b) {
    return std::array<double, 3>{double(a.low), double(a.high), a.radius} <
           std::array<double, 3>{double(b.low), double(b.high), b.radius};
  });
  const auto is_same = [](const Touching_pair& a, const Touching_pair& b) {
    return a.low == b.low && a.high == b.high;
  };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), is_same), pairs.end());
  return pairs;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TOUCHING_PAIRS_H
