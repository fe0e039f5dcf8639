// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PROJECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PROJECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Projected_nodes.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Projection of pairs of strands towards their distance.
class Strand_projection
{
  using Index = Projected_nodes::Index;

public:
  // Takes a factor of the distances. Nodes and pairs must outlive the projection.
  Strand_projection(const Projected_nodes& nodes, const Strand_pairs& pairs, double margin)
      : m_nodes(nodes), m_pairs(pairs), m_margin(margin)
  {
    for(const auto& [e, f] : pairs.pairs()) {
      const auto [i, j] = pairs.ends(e);
      const auto [k, l] = pairs.ends(f);
      if(!nodes.are_held({i, j, k, l})) m_moving.push_back({e, f});
    }
  }

  // Finds the pairs that may come close in the next sweeps, which visit these only: at first those
  // within a slack of their distance, later those that do if nodes move as far as since the last
  // search again. With the slack alone, and a bound of the distance instead of the distance itself,
  // fillings take a quarter longer (2026-11-28).
  void find_contacts(const std::vector<Vector>& x)
  {
    m_contacts.clear();
    for(const auto& [e, f] : m_moving) {
      const auto [i, j] = m_pairs.ends(e);
      const auto [k, l] = m_pairs.ends(f);
      const double distance = m_margin * m_pairs.distance(e, f);
      double reach = (1 + slack_of_contacts) * distance;
      if(Strand_pairs::are_surely_apart(reach, x[i], x[j], x[k], x[l])) continue;
      if(!m_found_at.empty())
        reach = (std::min)(reach, distance + motion_of_edge(i, j, x) + motion_of_edge(k, l, x));
      if(nearest_chord({x[i], x[j], x[k], x[l]}).squaredNorm() < reach * reach)
        m_contacts.push_back({{i, j, k, l}, distance, side({i, j, k, l}, x)});
    }
    m_found_at = x;
  }

  // Moves these pairs apart.
  void operator()(std::vector<Vector>& x)
  {
    for(Contact& contact : m_contacts) push_apart(x, contact);
  }

private:
  static constexpr double slack_of_contacts = 0.05; // in strand distances

  struct Contact
  {
    std::array<Index, 4> ends; // of one edge, and of the other
    double distance;           // to be kept
    Vector side;               // of the one edge, seen from the other
  };

  // how far that end of an edge which moved farther is from where it was at the last search
  double motion_of_edge(std::size_t v, std::size_t w, const std::vector<Vector>& x) const
  {
    return (std::max)((x[v] - m_found_at[v]).norm(), (x[w] - m_found_at[w]).norm());
  }

  // Edges that have passed through each other since the start are on the wrong side: pushed apart
  // from there, strands would press against each other for ever, since the guard stops them. Of 30
  // fillings of ten domains, two ended in such hooks (2026-11-26).
  Vector side(const std::array<Index, 4>& ends, const std::vector<Vector>& x) const
  {
    Segment_pair from, to;
    for(std::size_t k = 0; k < ends.size(); ++k) {
      from[k] = m_nodes.start(ends[k]);
      to[k] = x[ends[k]];
    }
    const Vector chord = nearest_chord(to);
    return do_pass(from, to) ? -1 * chord : chord;
  }

  // Each end moves in proportion to its weight in the nearest point. Edges that have passed through
  // each other move back.
  void push_apart(std::vector<Vector>& x, Contact& contact) const
  {
    const auto [i, j, k, l] = contact.ends;
    const double distance = contact.distance;
    const Vector a = x[i], b = x[j], c = x[k], d = x[l];
    const auto [s, t] = nearest_points(a, b, c, d);
    const Vector chord = (a + s * (b - a)) - (c + t * (d - c));
    const double square = chord.squaredNorm();
    if(!(square < distance * distance && square > 0)) return;
    const double now = std::sqrt(square);
    const double sign = chord.dot(contact.side) < 0 ? -1 : 1;
    contact.side = sign * chord;
    const double weight = (1 - s) * (1 - s) + s * s + (1 - t) * (1 - t) + t * t;
    const Vector push = (distance - sign * now) / (now * weight) * contact.side;
    m_nodes.move(x, i, (1 - s) * push);
    m_nodes.move(x, j, s * push);
    m_nodes.move(x, k, -(1 - t) * push);
    m_nodes.move(x, l, -t * push);
  }

  const Projected_nodes& m_nodes;
  const Strand_pairs& m_pairs;
  const double m_margin;
  std::vector<Strand_pairs::Pair> m_moving; // pairs in which a node can move
  std::vector<Contact> m_contacts;
  std::vector<Vector> m_found_at; // the positions at the last search
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_STRAND_PROJECTION_H
