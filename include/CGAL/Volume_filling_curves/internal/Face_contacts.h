// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_CONTACTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_CONTACTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/triangle_intersection.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The pairs of triangles of a soup that meet elsewhere than in a common vertex or a common edge.
// Decided exactly, after a broad phase with boxes: O(n log^2 n + k) for k pairs of triangles with
// intersecting boxes. CGAL's own search wants a mesh with halfedges, which a soup with defects does
// not make; here all of its other defects may be present.
template <typename Kernel>
class Face_contacts
{
public:
  using Point_3 = typename Kernel::Point_3;
  using Face = std::array<std::size_t, 3>;
  using Pair = std::pair<std::size_t, std::size_t>;

  static constexpr std::size_t max_count = 1000000; // their number can be quadratic

  // \pre no triangle is degenerate
  Face_contacts(const std::vector<Point_3>& points, const std::vector<Face>& faces)
      : m_points(points), m_faces(faces)
  {}

  // returns the pairs in lexicographic order, or about a million of them
  std::vector<Pair> find() const
  {
    std::vector<Box> boxes;
    std::vector<const Box*> pointers;
    boxes.reserve(m_faces.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f) {
      const auto& [a, b, c] = m_faces[f];
      boxes.emplace_back(m_points[a].bbox() + m_points[b].bbox() + m_points[c].bbox(), f);
    }
    for(const Box& box : boxes) pointers.push_back(&box);
    std::vector<Pair> found;
    const auto check = [&](const Box* a, const Box* b) {
      const Pair pair = std::minmax(a->info(), b->info());
      if(!are_in_contact(pair.first, pair.second)) return;
      found.push_back(pair);
      if(found.size() == max_count) throw Enough_contacts();
    };
    try {
      box_self_intersection_d(pointers.begin(), pointers.end(), check, std::ptrdiff_t(cutoff));
    } catch(const Enough_contacts&) {
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  bool are_in_contact(std::size_t f, std::size_t g) const
  {
    Face s = m_faces[f], t = m_faces[g];
    const std::size_t common = bring_common_to_front(s, t);
    if(common == 3) return true;
    if(common == 2) return are_folded(s, t);
    const Triangle p = triangle(s), q = triangle(t);
    if(common == 0) return m_triangles.do_intersect(p, q);
    // whatever they share beyond the common corner reaches the side opposite of it in one of them
    return does_meet(p[1], p[2], q) || does_meet(q[1], q[2], p);
  }

private:
  using Traits = Curve_flow_traits_3<Kernel>;
  using Triangle = typename Triangle_intersection<Kernel>::Triangle;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

  struct Enough_contacts
  {};

  static constexpr int cutoff = 50; // as for edges, see Self_contacts

  // returns the number of common vertices, and sorts them to the front in the same order
  static std::size_t bring_common_to_front(Face& s, Face& t)
  {
    std::size_t common = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      const auto found = std::find(t.begin() + static_cast<std::ptrdiff_t>(common), t.end(), s[i]);
      if(found == t.end()) continue;
      std::swap(t[common], *found);
      std::swap(s[common], s[i]);
      ++common;
    }
    return common;
  }

  // returns whether two triangles with a common edge lie in one plane on the same side of it
  bool are_folded(const Face& s, const Face& t) const
  {
    const Point_3 &a = m_points[s[0]], &b = m_points[s[1]], &c = m_points[s[2]];
    const Point_3& d = m_points[t[2]];
    return m_predicates.are_coplanar(a, b, c, d) &&
           typename Kernel::Coplanar_orientation_3()(a, b, c, d) == CGAL::POSITIVE;
  }

  bool does_meet(const Point_3& p, const Point_3& q, const Triangle& t) const
  {
    return m_predicates.does_segment_meet_triangle(p, q, t[0], t[1], t[2]);
  }

  Triangle triangle(const Face& f) const
  {
    return {m_points[f[0]], m_points[f[1]], m_points[f[2]]};
  }

  const std::vector<Point_3>& m_points;
  const std::vector<Face>& m_faces;
  Triangle_intersection<Kernel> m_triangles;
  Exact_predicates<Traits> m_predicates{Traits()};
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_CONTACTS_H
