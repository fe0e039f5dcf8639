// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINK_TRIVIALITY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINK_TRIVIALITY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/knots/Linking_numbers.h>
#include <CGAL/Volume_filling_curves/internal/knots/Separating_plane.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Proof that a link of several closed components is trivial. A nonzero linking number proves the
// contrary. A link is trivial if each component is a proved unknot and the components can be
// removed one after another: a component whose convex hull is disjoint from those of all remaining
// ones, or a triangle whose disk misses all others. Exact; quadratic in the number of components.
template <typename Network>
class Link_triviality
{
  using Traits = typename Network::Traits;
  using Points = typename Separating_plane<Traits>::Points;

public:
  explicit Link_triviality(const Network& curve)
      : m_curve(curve), m_predicates(curve.traits()), m_separating_plane(curve.traits())
  {
    for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
      m_points.emplace_back();
      for(std::size_t v = curve.first_node(c); v < curve.first_node(c + 1); ++v)
        m_points.back().push_back(curve.point(v));
    }
  }

  Link_status operator()(const std::vector<Unknot_proof>& proofs) const
  {
    const std::size_t n = m_curve.number_of_components();
    for(std::size_t c = 0; c < n; ++c)
      if(!m_curve.is_closed(c)) return Link_status::NOT_A_LINK;
    if(n < 2) return Link_status::NOT_A_LINK;
    if(has_linking_number()) return Link_status::LINKED;
    const bool are_unknots =
        std::find(proofs.begin(), proofs.end(), Unknot_proof::NONE) == proofs.end();
    return are_unknots && can_be_taken_apart() ? Link_status::TRIVIAL : Link_status::UNDECIDED;
  }

private:
  bool has_linking_number() const
  {
    const auto matrix = Linking_numbers<Network>(m_curve)();
    if(!matrix) return false;
    for(const auto& numbers : *matrix)
      if(std::any_of(numbers.begin(), numbers.end(), [](int number) { return number != 0; }))
        return true;
    return false;
  }

  bool can_be_taken_apart() const
  {
    std::vector<std::size_t> left(m_points.size());
    for(std::size_t c = 0; c < left.size(); ++c) left[c] = c;
    for(;;) {
      const auto removable = std::find_if(left.begin(), left.end(), [&](std::size_t c) {
        return std::all_of(left.begin(), left.end(),
                           [&](std::size_t other) { return other == c || is_apart(c, other); });
      });
      if(removable == left.end()) return left.empty();
      left.erase(removable);
    }
  }

  bool is_apart(std::size_t c, std::size_t other) const
  {
    return (m_points[c].size() == 3 && does_disk_miss(m_points[c], m_points[other])) ||
           m_separating_plane(m_points[c], m_points[other]);
  }

  bool does_disk_miss(const Points& triangle, const Points& polygon) const
  {
    for(std::size_t k = 0; k < polygon.size(); ++k)
      if(m_predicates.does_segment_meet_triangle(polygon[k], polygon[(k + 1) % polygon.size()],
                                                 triangle[0], triangle[1], triangle[2]))
        return false;
    return true;
  }

  const Network& m_curve;
  Exact_predicates<Traits> m_predicates;
  Separating_plane<Traits> m_separating_plane;
  std::vector<Points> m_points;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINK_TRIVIALITY_H
