// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_OVERLAPPING_BOXES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_OVERLAPPING_BOXES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The common part of queries for pairs of overlapping boxes.
struct Overlap_query
{
  double bound() const { return 1; }

  double entry(const Box_tree::Part& a, const Box_tree::Part& b) const
  {
    return do_overlap(a.hull(), b.hull()) ? 0 : 1;
  }
};

// Calls f(i, j), i < j, for each two boxes that overlap.
template <typename Function>
class Overlapping_boxes : public Overlap_query
{
public:
  Overlapping_boxes(const Box_tree& tree, Function f) : m_tree(tree), m_function(std::move(f)) {}

  void visit(const Box_tree::Part& a, const Box_tree::Part& b) const
  {
    m_tree.for_each_pair(a, b, [&](std::size_t i, std::size_t j) {
      if(do_overlap(m_tree.box(i), m_tree.box(j))) m_function(i, j);
    });
  }

private:
  const Box_tree& m_tree;
  Function m_function;
};

template <typename Function>
void for_each_overlapping_pair(const Box_tree& tree, const Function& f)
{
  const Overlapping_boxes<Function> query(tree, f);
  Nearest_pair_descent(tree, query).run();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_OVERLAPPING_BOXES_H
