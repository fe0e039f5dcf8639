// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_CONTACTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_CONTACTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Rope.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Contacts of a rope with itself, which push it apart: two edges stay a diameter apart if the rope
// between them is at least half a turn of the tightest bend, pi radii long. Edges with less rope in
// between are kept apart by the curvature (Schur's comparison theorem). The pairs that could touch
// are found once for all motions of nodes by up to `slack`, in near-linear time; each motion then
// takes linear time.
class Rope_contacts
{
public:
  static constexpr double slack = 0.2; // in radii

  void find(const Rope& rope)
  {
    measure(rope);
    m_pairs.clear();
    const Box_tree tree(boxes(rope));
    for_each_overlapping_pair(tree, [&](std::size_t v, std::size_t w) {
      if(rope_between(rope, v, w) >= CGAL_PI) m_pairs.push_back({index(v), index(w)});
    });
  }

  // Moves the ends of overlapping edges apart, pair by pair, each in proportion to its share in the
  // contact (position based dynamics; Mueller et al. 2007).
  void push_apart(Rope& rope) const
  {
    for(const auto& [v, w] : m_pairs) push_apart(rope, v, w);
  }

private:
  using Index = std::uint32_t;

  static constexpr double diameter = 2;

  static Index index(std::size_t v) { return static_cast<Index>(v); }

  // Nodes may both have moved.
  static std::vector<Bbox_3> boxes(const Rope& rope)
  {
    std::vector<Bbox_3> boxes;
    boxes.reserve(rope.size());
    for(std::size_t v = 0; v < rope.size(); ++v) {
      Box box;
      box.extend(rope.x[v]).extend(rope.x[rope.next[v]]);
      boxes.push_back(to_bbox(inflated(box, diameter / 2 + slack)));
    }
    return boxes;
  }

  // Sums up lengths from the first node of each component on.
  void measure(const Rope& rope)
  {
    m_start.assign(rope.size(), 0);
    m_length.clear();
    for(std::size_t first = 0; first < rope.size(); ++first) {
      if(rope.component[first] != m_length.size()) continue;
      double length = 0;
      std::size_t v = first;
      do {
        m_start[v] = length;
        length += rope.edge(v).norm();
        v = rope.next[v];
      } while(v != first);
      m_length.push_back(length);
    }
  }

  // the length between two edges, infinite between components
  double rope_between(const Rope& rope, std::size_t v, std::size_t w) const
  {
    if(rope.component[v] != rope.component[w]) return std::numeric_limits<double>::infinity();
    if(m_start[v] > m_start[w]) std::swap(v, w);
    const double there = m_start[w] - m_start[v];
    const double back = m_length[rope.component[v]] - there;
    return (std::min)(there - rope.edge(v).norm(), back - rope.edge(w).norm());
  }

  static void push_apart(Rope& rope, std::size_t v, std::size_t w)
  {
    Vector &a = rope.x[v], &b = rope.x[rope.next[v]];
    Vector &c = rope.x[w], &d = rope.x[rope.next[w]];
    const double reach = diameter + ((b - a).norm() + (d - c).norm()) / 2;
    if(((a - c) + (b - d)).squaredNorm() >= 4 * reach * reach) return; // so are the middles
    const auto [s, t] = nearest_points(a, b, c, d);
    const Vector chord = (a + s * (b - a)) - (c + t * (d - c));
    const double distance = chord.norm();
    if(!(distance < diameter && distance > 0)) return;
    const double weight = (1 - s) * (1 - s) + s * s + (1 - t) * (1 - t) + t * t;
    const Vector push = (diameter - distance) / (distance * weight) * chord;
    a += (1 - s) * push;
    b += s * push;
    c -= (1 - t) * push;
    d -= t * push;
  }

  std::vector<std::array<Index, 2>> m_pairs; // of edges, by their first nodes
  std::vector<double> m_start, m_length;     // of each edge, of each component
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_CONTACTS_H
