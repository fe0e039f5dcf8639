// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_NEIGHBORHOODS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_NEIGHBORHOODS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_list.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Nodes near a point, from a CGAL k-d tree over node indices. The tree holds only one of several
// coincident nodes: more of them than fit into a bucket degenerate it (before CGAL 6.2). Callers
// process all returned nodes, several at a time; returning all leaves that meet a ball is faster
// than testing their nodes. Nodes are therefore stored in the order of the leaves. O(n log n) time
// to build; queries of a built tree are safe in parallel.
class Node_neighborhoods
{
public:
  using Index = Node_list::Index;

  explicit Node_neighborhoods(const Vector_field& x)
  {
    const auto n = static_cast<std::size_t>(x.rows());
    m_points.reserve(n);
    for(std::size_t v = 0; v < n; ++v) m_points.push_back(to_kernel_point(row(x, v)));
    const std::vector<Index> indices = distinct_nodes();
    const Traits traits(CGAL::make_property_map(m_points));
    m_tree = std::make_unique<Tree>(indices.begin(), indices.end(), Splitter(bucket_size), traits);
    if(indices.empty()) return;
    m_tree->build();
    for(const Index v : *m_tree) m_nodes.push_back(v, row(x, v));
  }

  // in the order of the tree's leaves
  const Node_list& nodes() const { return m_nodes; }

  // Calls f(first, beyond) for ranges of `nodes()` that contain all nodes within `radius` of
  // `center`, and some more.
  template <typename Function>
  void for_each_run_near(const Vector& center, double radius, const Function& f) const
  {
    if(!m_points.empty()) descend(*m_tree->root(), center, radius * radius, Vector(), f);
  }

  // Replaces the contents of `found` by the nodes within `radius` of `center`, and some more.
  void find(const Vector& center, double radius, Node_list& found) const
  {
    found.clear();
    for_each_run_near(center, radius, [&](std::size_t first, std::size_t beyond) {
      found.append(m_nodes, first, beyond);
    });
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Traits = CGAL::Search_traits_adapter<Index,
                                             CGAL::Pointer_property_map<Point>::type,
                                             CGAL::Search_traits_3<Kernel>>;

  // Building a tree of a million nodes takes a second. A small one is built to its end in a few
  // milliseconds: CGAL loses 56 bytes of a tree whose construction ends by an exception.
  struct Splitter : CGAL::Sliding_midpoint<Traits>
  {
    using CGAL::Sliding_midpoint<Traits>::Sliding_midpoint;

    template <typename Separator, typename Points>
    void operator()(Separator& separator, Points& points, Points& others) const
    {
      constexpr std::size_t many = 10000;
      if(points.size() > many) check_run();
      CGAL::Sliding_midpoint<Traits>::operator()(separator, points, others);
    }
  };

  using Tree = CGAL::Kd_tree<Traits, Splitter>;

  static constexpr unsigned bucket_size = 20;

  // Takes how far the center is from the node's cell along each axis.
  template <typename Function>
  void descend(const Tree::Node& node,
               const Vector& center,
               double squared_radius,
               const Vector& gap,
               const Function& f) const
  {
    if(node.is_leaf()) {
      const auto& leaf = static_cast<const Tree::Leaf_node&>(node);
      const auto first = static_cast<std::size_t>(leaf.begin() - m_tree->begin());
      f(first, first + leaf.size());
      return;
    }
    const auto& inner = static_cast<const Tree::Internal_node&>(node);
    const int axis = inner.cutting_dimension();
    const auto descend_if_near = [&](const Tree::Node& child, double distance) {
      Vector farther = gap;
      farther[axis] = (std::max)(gap[axis], distance);
      if(farther.squaredNorm() <= squared_radius)
        descend(child, center, squared_radius, farther, f);
    };
    descend_if_near(*inner.lower(), center[axis] - inner.lower_high_value());
    descend_if_near(*inner.upper(), inner.upper_low_value() - center[axis]);
  }

  static Point to_kernel_point(const Vector& p) { return {p.x(), p.y(), p.z()}; }

  static std::uint64_t hash(const Point& p)
  {
    std::uint64_t h = 0;
    for(double c : {p.x(), p.y(), p.z()}) {
      std::uint64_t bits;
      c += 0.; // -0 is 0
      std::memcpy(&bits, &c, sizeof(bits));
      h = (h ^ bits) * 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
      h ^= h >> 29;
    }
    return h;
  }

  // The first of each set of coincident nodes, by a hash table with linear probing.
  std::vector<Index> distinct_nodes() const
  {
    constexpr Index none = (std::numeric_limits<Index>::max)();
    std::size_t size = 16;
    while(size < 2 * m_points.size()) size *= 2;
    std::vector<Index> table(size, none);
    std::vector<Index> distinct;
    distinct.reserve(m_points.size());
    for(Index v = 0; v < m_points.size(); ++v) {
      std::size_t slot = hash(m_points[v]) & (size - 1);
      while(table[slot] != none && m_points[table[slot]] != m_points[v])
        slot = (slot + 1) & (size - 1);
      if(table[slot] != none) continue;
      table[slot] = v;
      distinct.push_back(v);
    }
    return distinct;
  }

  std::vector<Point> m_points;
  std::unique_ptr<Tree> m_tree;
  Node_list m_nodes; // in the order of the tree's leaves
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_NEIGHBORHOODS_H
