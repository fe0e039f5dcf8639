// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_interval.h>
#include <CGAL/Volume_filling_curves/internal/curve/Strand_neighbors.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Minimum of a distance over pairs of edges, by branch and bound on a CGAL AABB tree that is
// intersected with itself. A pair of subtrees is skipped if their boxes are no closer than the best
// pair, or if all their edges are neighbors. Construction takes O(n log n) time; the search is
// near-linear if edges have few neighbors, since all other pairs are farther apart than the answer.
class Least_pair_distance
{
public:
  // All distances are those of the curve times `unit`. \pre the network has no garbage: its edges
  // are in the order of the curve
  template <typename Network>
  Least_pair_distance(const Network& curve, const Curve_intervals& spans, double unit)
      : m_spans(spans), m_tree(boxes(curve, unit))
  {}

  // Two edges, null ones if none are nearer than the bound.
  struct Pair
  {
    double distance;
    std::array<std::size_t, 2> edges = {Curve_interval::null, Curve_interval::null};
  };

  /* returns the pair of edges with the least `distance(e, f)` if that is below `bound`, and `bound`
   * without edges otherwise. Pieces of the curve with a `reach()` below `neighborhood` are passed
   * over.
   * \pre distance(e, f) is not below the distance of the boxes of e and f
   * \throws Run_stopped if a watch requests it
   */
  template <typename Distance>
  Pair nearest(double bound,
               double neighborhood,
               const Distance& distance,
               Run_watch* watch = nullptr) const
  {
    check(watch);
    Query<Distance> query(m_spans, m_tree, neighborhood, distance, bound, watch);
    Nearest_pair_descent(m_tree, query).run();
    return query.nearest();
  }

private:
  using Part = Box_tree::Part;

  template <typename Distance>
  class Query
  {
  public:
    Query(const Curve_intervals& spans,
          const Box_tree& tree,
          double neighborhood,
          const Distance& distance,
          double bound,
          Run_watch* watch)
        : m_spans(spans),
          m_tree(tree),
          m_neighborhood(neighborhood),
          m_distance(distance),
          m_nearest{bound},
          m_watch(watch)
    {}

    const Pair& nearest() const { return m_nearest; }
    double bound() const { return m_nearest.distance * m_nearest.distance; }

    double entry(const Part& a, const Part& b) const
    {
      check_sometimes(m_watch, m_entries);
      const Curve_interval first = span(a), second = span(b);
      if(first.is_comparable(second) && m_spans.reach(first, second) < m_neighborhood)
        return std::numeric_limits<double>::infinity();
      return squared_distance_of_boxes(a.hull(), b.hull());
    }

    void visit(const Part& a, const Part& b)
    {
      m_tree.for_each_pair(a, b, [&](std::size_t e, std::size_t f) {
        if(!(squared_distance_of_boxes(m_tree.box(e), m_tree.box(f)) < bound())) return;
        if(const double d = m_distance(e, f); d < m_nearest.distance) m_nearest = {d, {e, f}};
      });
    }

  private:
    Curve_interval span(const Part& part) const
    {
      return m_spans.of_edge[m_tree.first(part)].hull(m_spans.of_edge[m_tree.end(part) - 1]);
    }

    const Curve_intervals& m_spans;
    const Box_tree& m_tree;
    double m_neighborhood;
    const Distance& m_distance;
    Pair m_nearest;
    Run_watch* m_watch;
    mutable unsigned m_entries = 0;
  };

  template <typename Network>
  static std::vector<Bbox_3> boxes(const Network& curve, double unit)
  {
    std::vector<Bbox_3> result;
    result.reserve(curve.number_of_edges());
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      result.push_back(to_bbox(Box(unit * to_vector(curve.point(curve.source(e))))
                                   .extend(unit * to_vector(curve.point(curve.target(e))))));
    return result;
  }

  const Curve_intervals& m_spans;
  Box_tree m_tree;
};

// Least distance between two edges that are not neighbors along the curve (Strand_neighbors).
// Near-linear time for curves (Least_pair_distance).
template <typename Network>
class Least_clearance
{
public:
  // Takes the neighborhood of each edge, 0 or more.
  Least_clearance(const Network& curve, std::vector<double> neighborhoods)
      : m_curve(curve), m_unit(unit_of_size(curve)), m_neighbors(curve, std::move(neighborhoods))
  {}

  Least_clearance(const Network& curve, double neighborhood)
      : Least_clearance(curve, std::vector<double>(curve.number_of_edges(), neighborhood))
  {}

  // returns the nearest two edges, null ones if all are neighbors
  Least_pair_distance::Pair nearest(Run_watch* watch = nullptr) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double>& neighborhoods = m_neighbors.neighborhoods();
    if(neighborhoods.empty()) return {infinity};
    const Least_pair_distance pairs(m_curve, m_neighbors.spans(), m_unit);
    const auto distance_of_others = [&](std::size_t e, std::size_t f) {
      return are_neighbors(e, f) ? infinity : distance(e, f);
    };
    const double least = *std::min_element(neighborhoods.begin(), neighborhoods.end());
    auto pair = pairs.nearest(infinity, least, distance_of_others, watch);
    pair.distance /= m_unit;
    return pair;
  }

  double operator()(Run_watch* watch = nullptr) const { return nearest(watch).distance; }

  bool are_neighbors(std::size_t e, std::size_t f) const { return m_neighbors.are_neighbors(e, f); }

private:
  double distance(std::size_t e, std::size_t f) const
  {
    const auto point = [&](std::size_t v) { return Vector(m_unit * to_vector(m_curve.point(v))); };
    return std::sqrt(squared_segment_distance(point(m_curve.source(e)), point(m_curve.target(e)),
                                              point(m_curve.source(f)), point(m_curve.target(f))));
  }

  const Network& m_curve;
  const double m_unit;
  const Strand_neighbors<Network> m_neighbors;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H
