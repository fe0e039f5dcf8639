// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_PAIR_DESCENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_PAIR_DESCENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Traversal of the pairs of boxes of a tree, which descends into pairs of subtrees, the nearer one
// first, and skips pairs that cannot be nearer than the best so far. (CGAL's AABB tree answers
// single queries: one query per box visits all pairs twice and descends to each box anew.)
//
// Query: `double entry(const Part& a, const Part& b) const` is a lower bound for all pairs of a box
// of a and one of b, or of two in a = b; `double bound() const` is the best so far; and `void
// visit(const Part& a, const Part& b)`, where a precedes or equals b, may lower it.
template <typename Query>
class Nearest_pair_descent
{
  using Part = Box_tree::Part;

public:
  // Pairs of parts are visited as soon as both have at most `max_runs` runs.
  Nearest_pair_descent(const Box_tree& tree, Query& query, std::size_t max_runs = 1)
      : m_tree(tree), m_query(query), m_max_runs(max_runs)
  {}

  void run() const
  {
    if(!m_tree.is_empty()) run(m_tree.root(), m_tree.root());
  }

  // \pre a precedes b or is b
  void run(const Part& a, const Part& b) const
  {
    if(&a.hull() == &b.hull())
      descend_within(a);
    else
      descend(a, b, m_query.entry(a, b));
  }

private:
  void descend_within(const Part& a) const
  {
    if(!(m_query.entry(a, a) < m_query.bound())) return;
    if(a.number_of_runs() <= m_max_runs) return m_query.visit(a, a);
    const auto [left, right] = m_tree.children(a);
    descend_within(left);
    descend_within(right);
    descend(left, right, m_query.entry(left, right));
  }

  void descend(const Part& a, const Part& b, double entry) const
  {
    if(!(entry < m_query.bound())) return;
    if(a.number_of_runs() <= m_max_runs && b.number_of_runs() <= m_max_runs)
      return m_query.visit(a, b);
    if(a.number_of_runs() >= b.number_of_runs()) {
      const auto [left, right] = m_tree.children(a);
      descend_nearest_first(left, b, right, b);
    } else {
      const auto [left, right] = m_tree.children(b);
      descend_nearest_first(a, left, a, right);
    }
  }

  void descend_nearest_first(const Part& a, const Part& b, const Part& c, const Part& d) const
  {
    const double ab = m_query.entry(a, b), cd = m_query.entry(c, d);
    const bool is_ab_first = ab <= cd;
    if(is_ab_first) descend(a, b, ab);
    descend(c, d, cd);
    if(!is_ab_first) descend(a, b, ab);
  }

  const Box_tree& m_tree;
  Query& m_query;
  std::size_t m_max_runs;
};

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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_PAIR_DESCENT_H
