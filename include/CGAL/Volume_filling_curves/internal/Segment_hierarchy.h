// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEGMENT_HIERARCHY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEGMENT_HIERARCHY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Box.h>
#include <CGAL/Volume_filling_curves/internal/Strand_span.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The least of some distance over pairs of edges: branch and bound on a binary tree of boxes, met
// with itself. CGAL's AABB tree answers one query at a time and cannot pass over neighbours along
// the curve; here a pair of groups is left as soon as its boxes are as far apart as the best pair, or
// all of its edges are neighbours. Building takes O(n log n); the search is near linear while the
// neighbours per edge are few, since all else is farther away than the answer.
class Segment_hierarchy
{
public:
  // All distances are those of the curve times `unit`.
  template <typename Network>
  Segment_hierarchy(const Network& curve, const Strand_spans& spans, double unit)
      : m_spans(spans), m_order(curve.number_of_edges())
  {
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    m_boxes.reserve(m_order.size());
    for(std::size_t e = 0; e < m_order.size(); ++e) {
      m_boxes.push_back(Box::of(unit * to_vector(curve.point(curve.source(e)))));
      m_boxes.back() += unit * to_vector(curve.point(curve.target(e)));
    }
    if(!m_order.empty()) build(0, m_order.size());
  }

  /* returns the least of `bound` and of `distance(e, f)` over all pairs of edges.
   * Groups of edges with a `reach()` below `neighborhood` are passed over.
   * \pre distance(e, f) is not below the distance of the boxes of e and f
   */
  template <typename Distance>
  double least(double bound, double neighborhood, const Distance& distance) const
  {
    if(!m_groups.empty()) visit_within(0, neighborhood, distance, bound);
    return bound;
  }

private:
  static constexpr std::size_t leaf_size = 4;

  struct Group
  {
    Box box;
    Strand_span span;
    std::size_t begin, end; // in m_order
    std::size_t right;      // the left child is the next group; 0 for a leaf
  };

  std::size_t build(std::size_t begin, std::size_t end)
  {
    const std::size_t g = m_groups.size();
    m_groups.push_back(group(begin, end));
    if(end - begin <= leaf_size) return g;
    const std::size_t middle = split(m_groups[g]);
    build(begin, middle);
    const std::size_t right = build(middle, end);
    m_groups[g].right = right;
    return g;
  }

  Group group(std::size_t begin, std::size_t end) const
  {
    Group result{m_boxes[m_order[begin]], m_spans.of_edge[m_order[begin]], begin, end, 0};
    for(std::size_t i = begin + 1; i < end; ++i) {
      result.box += m_boxes[m_order[i]].min;
      result.box += m_boxes[m_order[i]].max;
      result.span = result.span.hull(m_spans.of_edge[m_order[i]]);
    }
    return result;
  }

  std::size_t split(const Group& group)
  {
    Eigen::Index axis;
    (group.box.max - group.box.min).maxCoeff(&axis);
    const auto iterator = [&](std::size_t i) {
      return m_order.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const auto center = [&](std::size_t e) { return m_boxes[e].min[axis] + m_boxes[e].max[axis]; };
    const std::size_t middle = group.begin + (group.end - group.begin) / 2;
    std::nth_element(iterator(group.begin), iterator(middle), iterator(group.end),
                     [&](std::size_t e, std::size_t f) { return center(e) < center(f); });
    return middle;
  }

  static double squared_distance(const Box& a, const Box& b)
  {
    return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0).squaredNorm();
  }

  template <typename Distance>
  void visit_within(std::size_t g, double reach, const Distance& distance, double& bound) const
  {
    const Group& group = m_groups[g];
    if(group.span.component != Strand_span::null && group.span.extent() < reach) return;
    if(group.right == 0) {
      for(std::size_t i = group.begin; i < group.end; ++i)
        for(std::size_t j = i + 1; j < group.end; ++j) visit_edges(i, j, distance, bound);
      return;
    }
    visit_within(g + 1, reach, distance, bound);
    visit_within(group.right, reach, distance, bound);
    visit_between(g + 1, group.right, reach, distance, bound);
  }

  template <typename Distance>
  void visit_between(
      std::size_t g, std::size_t h, double reach, const Distance& distance, double& bound) const
  {
    const Group &a = m_groups[g], &b = m_groups[h];
    if(squared_distance(a.box, b.box) >= bound * bound) return;
    if(a.span.is_comparable(b.span) && m_spans.reach(a.span, b.span) < reach) return;
    if(a.right == 0 && b.right == 0) {
      for(std::size_t i = a.begin; i < a.end; ++i)
        for(std::size_t j = b.begin; j < b.end; ++j) visit_edges(i, j, distance, bound);
      return;
    }
    if(a.right == 0 || (b.right != 0 && b.box.longest_side() > a.box.longest_side())) {
      std::swap(g, h);
    }
    std::size_t first = g + 1, second = m_groups[g].right;
    const auto distance_to = [&](std::size_t k) {
      return squared_distance(m_groups[k].box, m_groups[h].box);
    };
    if(distance_to(second) < distance_to(first)) std::swap(first, second);
    visit_between(first, h, reach, distance, bound);
    visit_between(second, h, reach, distance, bound);
  }

  template <typename Distance>
  void visit_edges(std::size_t i, std::size_t j, const Distance& distance, double& bound) const
  {
    const std::size_t e = m_order[i], f = m_order[j];
    if(squared_distance(m_boxes[e], m_boxes[f]) >= bound * bound) return;
    bound = (std::min)(bound, distance((std::min)(e, f), (std::max)(e, f)));
  }

  const Strand_spans& m_spans;
  std::vector<std::size_t> m_order;
  std::vector<Box> m_boxes; // per edge
  std::vector<Group> m_groups;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEGMENT_HIERARCHY_H
