// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_BROAD_PHASE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_BROAD_PHASE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/Bbox_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Broad phase of a motion: finds pairs of edges that could meet or come close, whose swept boxes,
// inflated by half the margin, overlap. A CGAL AABB tree of the boxes is intersected with itself.
// For edges of similar length this takes O(n log n + k) time for k pairs, 40 ns per edge
// (kernel_broad_phase, 2026-11-22).
class Broad_phase
{
public:
  using Edge_pair = std::array<std::uint32_t, 2>;

  template <typename ConcurrencyTag, typename Network>
  Broad_phase(ConcurrencyTag,
              const Network& curve,
              const Vector_field& before,
              const Vector_field& after,
              double margin)
      : m_tree(swept_boxes<ConcurrencyTag>(
            curve, before, after, [margin](std::size_t) { return margin / 2; }))
  {}

  // Takes a margin for each edge; that of a pair is their mean.
  template <typename ConcurrencyTag, typename Network>
  Broad_phase(ConcurrencyTag,
              const Network& curve,
              const Vector_field& before,
              const Vector_field& after,
              const std::vector<double>& margins)
      : m_tree(swept_boxes<ConcurrencyTag>(
            curve, before, after, [&margins](std::size_t e) { return margins[e] / 2; }))
  {}

  // Returns the pairs (e, f), e > f, for which is_wanted(e, f), in an order that depends on neither
  // the tag nor the number of threads. The predicate is no template argument: fill() has five, and
  // would compile the search for each.
  template <typename ConcurrencyTag>
  std::vector<Edge_pair> pairs(const std::function<bool(std::size_t, std::size_t)>& is_wanted) const
  {
    Close_parts close;
    Nearest_pair_descent(m_tree, close, runs_per_task).run();
    const std::size_t n = close.parts.size();
    std::vector<std::vector<Edge_pair>> found((n + block - 1) / block);
    for_each_block<ConcurrencyTag>(n, block, [&](std::size_t begin, std::size_t end) {
      auto& pairs = found[begin / block];
      const Overlapping_boxes query(m_tree, [&](std::size_t f, std::size_t e) {
        if(is_wanted(e, f))
          pairs.push_back({static_cast<std::uint32_t>(e), static_cast<std::uint32_t>(f)});
      });
      for(std::size_t k = begin; k < end; ++k)
        Nearest_pair_descent(m_tree, query).run(close.parts[k][0], close.parts[k][1]);
    });
    std::vector<Edge_pair> all;
    all.reserve(
        std::accumulate(found.begin(), found.end(), std::size_t(0),
                        [](std::size_t sum, const auto& pairs) { return sum + pairs.size(); }));
    for(const auto& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
    return all;
  }

private:
  using Part = Box_tree::Part;

  static constexpr std::size_t runs_per_task = 128; // pairs of such parts are dealt to threads
  static constexpr std::size_t block = 16;

  struct Close_parts : Overlap_query
  {
    std::vector<std::array<Part, 2>> parts;

    void visit(const Part& a, const Part& b) { parts.push_back({a, b}); }
  };

  // The ends of an edge move one after the other (section 4.3 of the paper), in either order; the
  // box holds the triangles that it sweeps in both.
  template <typename ConcurrencyTag, typename Network, typename Inflation>
  static std::vector<Bbox_3> swept_boxes(const Network& curve,
                                         const Vector_field& before,
                                         const Vector_field& after,
                                         const Inflation& inflation)
  {
    std::vector<Bbox_3> boxes(curve.number_of_edges());
    for_each_index<ConcurrencyTag>(boxes.size(), [&](std::size_t e) {
      Box box;
      for(const std::size_t v : {curve.source(e), curve.target(e)})
        box.extend(row(before, v)).extend(row(after, v));
      boxes[e] = to_bbox(inflated(box, inflation(e)));
    });
    return boxes;
  }

  Box_tree m_tree;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_BROAD_PHASE_H
