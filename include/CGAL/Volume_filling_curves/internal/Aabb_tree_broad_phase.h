// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_AABB_TREE_BROAD_PHASE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_AABB_TREE_BROAD_PHASE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Grid_broad_phase.h>
#include <CGAL/Volume_filling_curves/internal/cgal_compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The same candidates from a CGAL AABB tree over the swept boxes, each represented by its diagonal,
// a degenerate triangle with the same box; the traversal compares boxes only. (The two triangles
// that an edge sweeps while its ends move one after the other, section 4.3 of the paper, do not lie
// in the boxes of those that it sweeps while they take the other order.) O(n log n).
template <typename Network>
class Aabb_tree_broad_phase
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = Aabb_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<Aabb_traits<Kernel, Primitive>>;

public:
  Aabb_tree_broad_phase(const Network& curve,
                        const Vector_field& before,
                        const Vector_field& after,
                        double margin)
      : m_margin(margin)
  {
    const std::size_t n = curve.number_of_edges();
    m_boxes.reserve(n);
    m_triangles.reserve(n);
    const auto point = [](const Vector& v) { return Point(v.x(), v.y(), v.z()); };
    for(std::size_t e = 0; e < n; ++e) {
      const Box box = swept_box(curve, e, before, after);
      m_boxes.push_back(box);
      m_triangles.emplace_back(point(box.min), point(box.max), point(box.max));
    }
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
    m_tree.build();
  }

  // Calls f(j) once for every candidate j < e.
  template <typename Function>
  void for_each_candidate_below(std::size_t e, const Function& f) const
  {
    if(m_tree.empty()) return;
    std::vector<std::size_t> found;
    Overlap_traversal traversal{m_triangles.cbegin(), found};
    const Box box = m_boxes[e].inflated(m_margin);
    m_tree.traversal(
        Bbox_3(box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y(), box.max.z()),
        traversal);
    for(std::size_t j : found)
      if(j < e && do_overlap(box, m_boxes[j])) f(j);
  }

private:
  struct Overlap_traversal
  {
    typename Triangles::const_iterator first;
    std::vector<std::size_t>& found;

    bool go_further() const { return true; }
    void intersection(const Bbox_3&, const Primitive& primitive)
    {
      found.push_back(static_cast<std::size_t>(primitive.id() - first));
    }
    template <typename Node>
    bool do_intersect(const Bbox_3& query, const Node& node) const
    {
      return CGAL::do_overlap(query, node.bbox());
    }
  };

  double m_margin;
  std::vector<Box> m_boxes;
  Triangles m_triangles;
  Tree m_tree;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_AABB_TREE_BROAD_PHASE_H
