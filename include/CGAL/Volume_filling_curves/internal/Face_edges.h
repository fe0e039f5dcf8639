// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_EDGES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_EDGES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Which triangles of a soup meet in which edges: the sides of all triangles, sorted by their ends.
// O(n log n).
class Face_edges
{
public:
  using Face = std::array<std::size_t, 3>;

  // A side of a triangle, from its lower to its higher vertex.
  struct Side
  {
    std::size_t low, high, face;
    bool is_forward; // whether the triangle runs through it from low to high
  };

  using Sides = std::vector<Side>;
  using Range = std::pair<Sides::const_iterator, Sides::const_iterator>;

  explicit Face_edges(const std::vector<Face>& faces)
  {
    for(std::size_t f = 0; f < faces.size(); ++f) {
      for(std::size_t i = 0; i < 3; ++i) {
        const std::size_t v = faces[f][i], w = faces[f][(i + 1) % 3];
        m_sides.push_back({(std::min)(v, w), (std::max)(v, w), f, v < w});
      }
    }
    std::sort(m_sides.begin(), m_sides.end(), [](const Side& s, const Side& t) {
      return std::array{s.low, s.high, s.face} < std::array{t.low, t.high, t.face};
    });
  }

  // Calls f(first, last) with the sides that lie in an edge, for one edge after the other.
  template <typename Function>
  void for_each_edge(const Function& f) const
  {
    for(auto first = m_sides.begin(); first != m_sides.end();) {
      auto last = first;
      while(last != m_sides.end() && last->low == first->low && last->high == first->high) ++last;
      f(first, last);
      first = last;
    }
  }

private:
  Sides m_sides;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_EDGES_H
