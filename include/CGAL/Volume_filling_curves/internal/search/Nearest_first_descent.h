// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_FIRST_DESCENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_FIRST_DESCENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// returns the squared distance of p to the box, 0 inside, as `entry()` of queries for distances
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

// Visits the primitives of a CGAL AABB tree, the nearer child first, and leaves whatever cannot be
// nearer than the best so far. CGAL's own traversal takes the left child first and decides with
// filtered predicates whether a sphere meets a box; comparing distances in plain double is enough
// for a value that is rounded anyway.
//
// Query: `double entry(const Bbox_3&) const` is a lower bound for everything in the box,
// `double bound() const` the best so far, and `void visit(const Primitive&, std::size_t i)` may
// lower it; i is the number of the primitive in the order of the tree's leaves from left to right,
// in which the caller may keep its own data, close together for neighbors.
template <typename Tree, typename Query>
class Nearest_first_descent
{
public:
  explicit Nearest_first_descent(Query& query) : m_query(query) {}

  // \pre the tree is built and has at least two primitives
  void run(const Tree& tree)
  {
    if(m_query.entry(tree.root_node()->bbox()) < m_query.bound())
      descend(*tree.root_node(), 0, tree.size());
  }

private:
  // the primitives below the node have the numbers from `first` on
  template <typename Node>
  void descend(const Node& node, std::size_t first, std::size_t size)
  {
    if(size <= 3) return visit_last(node, first, size);
    const Node &left = node.left_child(), &right = node.right_child();
    const double to_left = m_query.entry(left.bbox()), to_right = m_query.entry(right.bbox());
    const std::size_t half = size / 2;
    const bool is_left_first = to_left <= to_right;
    if(is_left_first && to_left < m_query.bound()) descend(left, first, half);
    if(to_right < m_query.bound()) descend(right, first + half, size - half);
    if(!is_left_first && to_left < m_query.bound()) descend(left, first, half);
  }

  // a node of two primitives, or of one and a node of two
  template <typename Node>
  void visit_last(const Node& node, std::size_t first, std::size_t size)
  {
    m_query.visit(node.left_data(), first);
    if(size == 2)
      m_query.visit(node.right_data(), first + 1);
    else if(m_query.entry(node.right_child().bbox()) < m_query.bound())
      visit_last(node.right_child(), first + 1, 2);
  }

  Query& m_query;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_NEAREST_FIRST_DESCENT_H
