// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_BOX_TREE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_BOX_TREE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/support/cgal_compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// CGAL AABB tree over boxes that are already in spatial order: that of the edges along a curve, or
// a `Surface_area_order`. Nothing is sorted: every node holds consecutive runs of boxes, and each
// child gets half of them. (CGAL's default, a split at the median of the longest axis, takes longer
// than all queries for pairs of edges.) A leaf of CGAL's tree is a run, whose boxes are adjacent in
// an array. Construction takes O(n log n) unions of boxes, 17 ns per box for 100,000
// (kernel_broad_phase). Queries descend by `Nearest_pair_descent` and `Nearest_first_descent`.
class Box_tree
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Boxes = std::vector<Bbox_3>;

  // Run of boxes. The tree only uses their hull; the other members are required by CGAL's concept
  // of a primitive.
  struct Primitive
  {
    using Id = std::size_t;
    using Point = Kernel::Point_3;
    using Datum = Kernel::Iso_cuboid_3;
    using Point_reference = Point;
    using Datum_reference = Datum;

    const Bbox_3* hull;

    explicit Primitive(Boxes::const_iterator it) : hull(&*it) {}
    Id id() const { return 0; }
    Datum datum() const { return Datum(*hull); }
    Point reference_point() const { return {hull->xmin(), hull->ymin(), hull->zmin()}; }
  };

  using Tree = CGAL::AABB_tree<Aabb_traits<Kernel, Primitive>>;
  using Node = std::remove_pointer_t<decltype(std::declval<const Tree&>().root_node())>;

public:
  // Consecutive runs of boxes: all that is below a node of the tree, or a single run.
  class Part
  {
  public:
    const Bbox_3& hull() const { return *m_hull; }
    std::size_t number_of_runs() const { return m_size; }

  private:
    friend class Box_tree;

    Part(const Node* node, const Bbox_3& hull, std::size_t first, std::size_t size)
        : m_node(node), m_hull(&hull), m_first(first), m_size(size)
    {}

    const Node* m_node; // null for a single run
    const Bbox_3* m_hull;
    std::size_t m_first, m_size; // in runs
  };

  Box_tree() = default;

  // Takes boxes that come in an order in space, as along a curve, in runs of the same length.
  explicit Box_tree(Boxes boxes) : m_boxes(std::move(boxes))
  {
    const std::size_t n = m_boxes.size();
    for(std::size_t k = 0; k < n; k += run_length_along_curves)
      m_run_ends.push_back(static_cast<std::uint32_t>((std::min)(k + run_length_along_curves, n)));
    build();
  }

  // Takes the indices where runs end; a run may be empty.
  Box_tree(Boxes boxes, std::vector<std::uint32_t> run_ends)
      : m_boxes(std::move(boxes)), m_run_ends(std::move(run_ends))
  {
    build();
  }

  // The tree points at the hulls, which stay where they are if their vector is moved.
  Box_tree(Box_tree&&) = default;
  Box_tree& operator=(Box_tree&&) = default;

  bool is_empty() const { return m_boxes.empty(); }
  const Bbox_3& box(std::size_t k) const { return m_boxes[k]; }

  // \pre the tree is not empty
  Part root() const
  {
    return m_hulls.size() == 1 ? run(0) : part(*m_tree.root_node(), 0, m_hulls.size());
  }

  // \pre the part is no single run
  std::array<Part, 2> children(const Part& p) const
  {
    const std::size_t half = p.m_size / 2, middle = p.m_first + half;
    if(p.m_size == 2) return {run(p.m_first), run(middle)};
    const Part right = part(p.m_node->right_child(), middle, p.m_size - half);
    if(p.m_size == 3) return {run(p.m_first), right};
    return {part(p.m_node->left_child(), p.m_first, half), right};
  }

  // the boxes of a part are first(p), ..., end(p) - 1
  std::size_t first(const Part& p) const { return p.m_first == 0 ? 0 : m_run_ends[p.m_first - 1]; }
  std::size_t end(const Part& p) const { return m_run_ends[p.m_first + p.m_size - 1]; }

  // Calls f(i, j), i < j, for all pairs of boxes in a part, or of one in a part and one in a later
  // part.
  template <typename Function>
  void for_each_pair(const Part& a, const Part& b, const Function& f) const
  {
    const bool is_same = a.m_first == b.m_first;
    for(std::size_t j = first(b); j < end(b); ++j)
      for(std::size_t i = first(a); i < (is_same ? j : end(a)); ++i) f(i, j);
  }

private:
  // 3 and 6 are as fast, 2 and 8 slower by a tenth
  static constexpr std::size_t run_length_along_curves = 4;

  void build()
  {
    m_hulls.reserve(m_run_ends.size());
    std::size_t k = 0;
    for(const std::uint32_t end : m_run_ends) {
      Bbox_3 hull;
      for(; k < end; ++k) hull += m_boxes[k];
      m_hulls.push_back(hull);
    }
    m_tree.insert(m_hulls.cbegin(), m_hulls.cend());
    m_tree.custom_build(
        [](auto first, auto beyond) {
          Bbox_3 hull = *first->hull;
          for(++first; first != beyond; ++first) hull += *first->hull;
          return hull;
        },
        [](auto, auto, const Bbox_3&) {}); // keeps the order
  }

  static Part part(const Node& node, std::size_t first, std::size_t size)
  {
    return {&node, node.bbox(), first, size};
  }

  Part run(std::size_t k) const { return {nullptr, m_hulls[k], k, 1}; }

  Boxes m_boxes;
  std::vector<std::uint32_t> m_run_ends;
  Boxes m_hulls; // of the runs
  Tree m_tree;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_BOX_TREE_H
