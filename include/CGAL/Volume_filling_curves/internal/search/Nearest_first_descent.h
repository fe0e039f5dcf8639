// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_FIRST_DESCENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_FIRST_DESCENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Returns the squared distance from p to the box, 0 inside, the `entry()` of distance queries.
inline double squared_distance_to_box(const Vector& p, const Bbox_3& box)
{
  const auto gap = [](double low, double x, double high) {
    return (std::max)((std::max)(low - x, x - high), 0.);
  };
  const double x = gap(box.xmin(), p.x(), box.xmax());
  const double y = gap(box.ymin(), p.y(), box.ymax());
  const double z = gap(box.zmin(), p.z(), box.zmax());
  return x * x + y * y + z * z;
}

// Visits the boxes of a tree, the nearer child first, and leaves whatever cannot be nearer than the
// best so far. (CGAL's traversal of its AABB tree takes the left child first and decides with
// filtered predicates whether a sphere meets a box; comparing distances in plain double is enough
// for a value that is rounded anyway.)
//
// Query: `double entry(const Bbox_3&) const` is a lower bound for everything in the box,
// `double bound() const` the best so far, and `void visit(std::size_t i)` may lower it; i is the
// index of the box in the order of the tree's leaves, in which the caller may store its own data,
// hence neighbors close together.
template <typename Query>
class Nearest_first_descent
{
  using Part = Box_tree::Part;

public:
  Nearest_first_descent(const Box_tree& tree, Query& query) : m_tree(tree), m_query(query) {}

  void run()
  {
    if(m_tree.is_empty()) return;
    const Part root = m_tree.root();
    if(m_query.entry(root.hull()) < m_query.bound()) descend(root);
  }

private:
  void descend(const Part& part)
  {
    if(part.number_of_runs() == 1) {
      for(std::size_t i = m_tree.first(part); i < m_tree.end(part); ++i) m_query.visit(i);
      return;
    }
    const auto children = m_tree.children(part);
    const double entries[] = {m_query.entry(children[0].hull()), m_query.entry(children[1].hull())};
    const std::size_t nearer = entries[1] < entries[0] ? 1 : 0;
    for(const std::size_t k : {nearer, 1 - nearer})
      if(entries[k] < m_query.bound()) descend(children[k]);
  }

  const Box_tree& m_tree;
  Query& m_query;
};

template <typename May_hold, typename Predicate>
struct Any_leaf_query
{
  const May_hold& may_hold;
  const Predicate& predicate;
  bool is_found = false;

  double bound() const { return is_found ? 0 : 1; }
  double entry(const Bbox_3& box) const { return may_hold(box) ? 0 : 1; }
  void visit(std::size_t i) { is_found = is_found || predicate(i); }
};

// Returns whether `predicate(i)` holds for a leaf i. Leaves out parts of the tree for whose boxes
// `may_hold(box)` does not hold, and ends with the first such leaf.
template <typename May_hold, typename Predicate>
bool any_leaf(const Box_tree& tree, const May_hold& may_hold, const Predicate& predicate)
{
  using Query = Any_leaf_query<May_hold, Predicate>;
  Query query{may_hold, predicate};
  Nearest_first_descent<Query>(tree, query).run();
  return query.is_found;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_FIRST_DESCENT_H
