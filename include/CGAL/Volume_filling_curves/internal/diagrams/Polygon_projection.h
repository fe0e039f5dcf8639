// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_POLYGON_PROJECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_POLYGON_PROJECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Projection_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Closed polygons, one after the other.
struct Closed_polygons
{
  std::vector<Vector> points;
  std::vector<std::size_t> ends; // one past the last point of each polygon

  void close() { ends.push_back(points.size()); } // the points since the last one that was closed
};

// Diagram of disjoint closed polygons, projected along a direction. Every decision rests on exact
// signs; doubles only select pairs of edges, by boxes with a margin. A direction is generic if in
// the image no node lies on an edge, no edge is a point and no two crossings coincide; other
// directions are refused. O(n log n + k) for k pairs of overlapping boxes.
class Polygon_projection
{
public:
  static constexpr std::size_t none = ~std::size_t(0);

  // The edges from `lifted` on pass above all others, as if they were lifted towards the viewer.
  // They must not cross each other.
  Polygon_projection(const Closed_polygons& polygons,
                     const Viewing_direction& direction,
                     std::size_t lifted = none)
      : m_polygons(polygons),
        m_predicates(polygons.points, direction),
        m_next(polygons.points.size()),
        m_lifted(lifted)
  {
    for(std::size_t v = 0, c = 0; v < m_next.size(); ++v) {
      while(v == polygons.ends[c]) ++c;
      const std::size_t first = c == 0 ? 0 : polygons.ends[c - 1];
      m_next[v] = v + 1 == polygons.ends[c] ? first : v + 1;
    }
    const Vector d(direction[0], direction[1], direction[2]);
    m_right = d.normalized().unitOrthogonal();
    m_up = d.normalized().cross(m_right);
  }

  // Returns nothing if the direction is not generic.
  // \throws Run_stopped in a Watched_scope
  std::optional<Planar_diagram> operator()()
  {
    if(!find_crossings() || !sort_passes()) return std::nullopt;
    return numbered();
  }

private:
  // Edge v leads from node v to the next one.
  struct Pass
  {
    std::size_t edge, other, crossing;
    Projection_predicates::Approximation position; // on the edge
    bool is_over;
  };

  bool find_crossings()
  {
    bool is_generic = true;
    unsigned pairs = 0;
    for_each_overlapping_pair(Box_tree(images_of_edges()), [&](std::size_t e, std::size_t f) {
      check_run_sometimes(pairs);
      if(is_generic) is_generic = meet(e, f);
    });
    return is_generic;
  }

  std::vector<Bbox_3> images_of_edges() const
  {
    constexpr double rounding = 1e-14; // of coordinates, relative to the largest one
    double size = 0;
    for(const Vector& p : m_polygons.points) size = (std::max)(size, p.cwiseAbs().maxCoeff());
    std::vector<Bbox_3> boxes;
    boxes.reserve(m_next.size());
    for(std::size_t e = 0; e < m_next.size(); ++e)
      boxes.push_back(to_bbox(inflated(Box(image(e)).extend(image(m_next[e])), rounding * size)));
    return boxes;
  }

  Vector image(std::size_t v) const
  {
    const Vector& p = m_polygons.points[v];
    return {m_right.dot(p), m_up.dot(p), 0};
  }

  // Records the crossing of two edges, if they cross. Returns false if the images touch otherwise.
  bool meet(std::size_t e, std::size_t f)
  {
    if(m_next[e] == f) return are_apart_at(f, e, m_next[f]);
    if(m_next[f] == e) return are_apart_at(e, f, m_next[e]);
    const std::size_t p = e, q = m_next[e], r = f, s = m_next[f];
    const Sign to_r = m_predicates.turn(p, q, r), to_s = m_predicates.turn(p, q, s);
    if(to_r == to_s && to_r != ZERO) return true;
    const Sign to_p = m_predicates.turn(r, s, p), to_q = m_predicates.turn(r, s, q);
    if(to_p == to_q && to_p != ZERO) return true;
    if(to_r == ZERO || to_s == ZERO || to_p == ZERO || to_q == ZERO)
      return to_r == ZERO && to_s == ZERO && are_apart_on_line(p, q, r, s);
    return cross(e, f, to_s == POSITIVE);
  }

  // Edges from node v to p and to q overlap only if they have the same direction.
  bool are_apart_at(std::size_t v, std::size_t p, std::size_t q) const
  {
    return m_predicates.turn(v, p, q) != ZERO ||
           m_predicates.direction_on_line(v, p, q) == NEGATIVE;
  }

  // Edges on one line: r and s are both beyond p, or both beyond q.
  bool are_apart_on_line(std::size_t p, std::size_t q, std::size_t r, std::size_t s) const
  {
    const auto are_beyond = [&](std::size_t end, std::size_t start) {
      return m_predicates.direction_on_line(end, start, r) == NEGATIVE &&
             m_predicates.direction_on_line(end, start, s) == NEGATIVE;
    };
    return are_beyond(p, q) || are_beyond(q, p);
  }

  // Edge f crosses edge e to its left or right. The tetrahedron of the four nodes has the sign of
  // the crossing.
  bool cross(std::size_t e, std::size_t f, bool is_leftwards)
  {
    const std::size_t p = e, q = m_next[e], r = f, s = m_next[f];
    const bool is_lifted = (std::max)(e, f) >= m_lifted;
    const Sign sign = is_lifted ? ((e >= m_lifted) == is_leftwards ? POSITIVE : NEGATIVE)
                                : m_predicates.orientation(p, q, r, s);
    if(sign == ZERO) return false; // the edges meet
    const bool is_over = (sign == POSITIVE) == is_leftwards;
    m_passes.push_back({e, f, m_signs.size(), m_predicates.approximate_place(p, q, r, s), is_over});
    m_passes.push_back(
        {f, e, m_signs.size(), m_predicates.approximate_place(r, s, p, q), !is_over});
    m_signs.push_back(sign);
    return true;
  }

  // along the polygons; returns false if two coincide. Doubles order nearly all
  // of them, exact comparisons the rest.
  bool sort_passes()
  {
    std::sort(m_passes.begin(), m_passes.end(), [](const Pass& a, const Pass& b) {
      return std::tie(a.edge, a.position.value, a.crossing) <
             std::tie(b.edge, b.position.value, b.crossing);
    });
    for(std::size_t i = 1; i < m_passes.size(); ++i)
      for(std::size_t k = i; k > 0 && m_passes[k - 1].edge == m_passes[k].edge; --k) {
        const Sign sign = compare(m_passes[k - 1], m_passes[k]);
        if(sign == ZERO) return false;
        if(sign == NEGATIVE) break;
        std::swap(m_passes[k - 1], m_passes[k]);
      }
    return true;
  }

  // whether a comes before b on their edge
  Sign compare(const Pass& a, const Pass& b) const
  {
    const double distance = a.position.value - b.position.value;
    if(std::abs(distance) > a.position.error + b.position.error)
      return distance > 0 ? POSITIVE : NEGATIVE;
    return CGAL::compare(exact_place(a), exact_place(b));
  }

  Exact_rational exact_place(const Pass& pass) const
  {
    return m_predicates.exact_place(pass.edge, m_next[pass.edge], pass.other, m_next[pass.other]);
  }

  // Numbers arcs and crossings in their order along the polygons.
  Planar_diagram numbered()
  {
    Planar_diagram diagram;
    std::vector<std::size_t> numbers(m_signs.size(), none);
    auto first = m_passes.begin();
    for(const std::size_t end : m_polygons.ends) {
      auto last = first;
      for(; last != m_passes.end() && last->edge < end; ++last)
        if(numbers[last->crossing] == none) {
          numbers[last->crossing] = diagram.crossings.size();
          diagram.crossings.emplace_back();
        }
      if(first == last) ++diagram.number_of_free_loops;
      orient_pair(first, last, numbers);
      number_arcs(first, last, numbers, diagram);
      first = last;
    }
    return diagram;
  }

  using Passes = std::vector<Pass>::iterator;

  // A component of two arcs above all others begins at the crossing with the smaller number, see
  // Diagram_strands.
  static void orient_pair(Passes first, Passes last, const std::vector<std::size_t>& numbers)
  {
    if(last - first == 2 && first->is_over && first[1].is_over &&
       numbers[first->crossing] > numbers[first[1].crossing])
      std::iter_swap(first, first + 1);
  }

  void number_arcs(Passes first,
                   Passes last,
                   const std::vector<std::size_t>& numbers,
                   Planar_diagram& diagram) const
  {
    const auto start = static_cast<std::uint32_t>(first - m_passes.begin());
    for(Passes pass = first; pass != last; ++pass) {
      const auto in = static_cast<std::uint32_t>(pass - m_passes.begin());
      const std::uint32_t out = pass + 1 == last ? start : in + 1;
      auto& x = diagram.crossings[numbers[pass->crossing]];
      const std::size_t k = !pass->is_over ? 0 : m_signs[pass->crossing] == POSITIVE ? 3 : 1;
      x[k] = in;
      x[(k + 2) % 4] = out;
    }
  }

  const Closed_polygons& m_polygons;
  const Projection_predicates m_predicates;
  std::vector<std::size_t> m_next;
  const std::size_t m_lifted;
  Vector m_right, m_up; // span the image
  std::vector<Pass> m_passes;
  std::vector<Sign> m_signs; // of the crossings
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_POLYGON_PROJECTION_H
