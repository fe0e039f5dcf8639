// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINK_TRIVIALITY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINK_TRIVIALITY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/knots/Linking_numbers.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for a plane that separates the convex hulls of two point sets: Gilbert's iteration (1966)
// approaches the shortest vector between the hulls in double arithmetic, and every plane orthogonal
// to an iterate that seems to separate them is verified exactly, with the orientation predicate. A
// plane found is a proof; none may be found for hulls that nearly touch. Linear time per iteration.
// All searches together visit a limited number of points, in about a tenth of a second.
template <typename Traits>
class Separating_plane
{
public:
  using Point_3 = typename Traits::Point_3;
  using Points = std::vector<Point_3>;

  explicit Separating_plane(const Traits& traits) : m_traits(traits) {}

  // returns whether a plane was found that has all of p strictly on one side and all of q strictly
  // on the other
  bool operator()(const Points& p, const Points& q)
  {
    constexpr int max_iterations = 200;
    Vector nearest = to_vector(p.front()) - to_vector(q.front());
    for(int k = 0; k < max_iterations && m_visits_left >= p.size() + q.size(); ++k) {
      m_visits_left -= p.size() + q.size();
      const double scale = nearest.norm();
      if(!(scale > 0)) return false;
      const Vector low_p = extreme(p, -nearest), high_q = extreme(q, nearest);
      if(nearest.dot(low_p - high_q) > 0 && does_separate(p, q, nearest, (low_p + high_q) / 2))
        return true;
      const Vector step = low_p - high_q - nearest;
      const double length2 = step.squaredNorm();
      if(!(length2 > 0)) return false;
      nearest += std::clamp(-nearest.dot(step) / length2, 0., 1.) * step;
    }
    return false;
  }

private:
  static Vector extreme(const Points& points, const Vector& direction)
  {
    double most = -std::numeric_limits<double>::infinity();
    Vector best;
    for(const Point_3& point : points) {
      const Vector x = to_vector(point);
      if(direction.dot(x) > most) {
        most = direction.dot(x);
        best = x;
      }
    }
    return best;
  }

  bool does_separate(const Points& p, const Points& q, const Vector& normal, const Vector& x) const
  {
    const Vector u = normal.norm() * normal.unitOrthogonal();
    const Vector v = normal.normalized().cross(u);
    const Point_3 a = to_point(x, m_traits), b = to_point(Vector(x + u), m_traits);
    const Point_3 c = to_point(Vector(x + v), m_traits);
    const auto orientation = m_traits.orientation_3_object();
    const auto are_all = [&](const Points& points, Orientation side) {
      return std::all_of(points.begin(), points.end(),
                         [&](const Point_3& point) { return orientation(a, b, c, point) == side; });
    };
    return (are_all(p, POSITIVE) && are_all(q, NEGATIVE)) ||
           (are_all(p, NEGATIVE) && are_all(q, POSITIVE));
  }

  const Traits& m_traits;
  std::size_t m_visits_left = 10'000'000;
};

// whether the curves are several closed ones
template <typename Network>
bool is_link(const Network& curves)
{
  for(std::size_t c = 0; c < curves.number_of_components(); ++c)
    if(!curves.is_closed(c)) return false;
  return curves.number_of_components() > 1;
}

// Proof that a link of several closed components is trivial. A nonzero linking number proves the
// contrary. A link is trivial if each component is a proved unknot and the components can be
// removed one after another: a component whose convex hull is disjoint from those of all remaining
// ones, or a triangle whose disk misses all others. Exact; quadratic in the number of components,
// of which most need the comparison of their boxes only: 4,000 take 0.1 seconds, 34 without it.
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
      m_boxes.emplace_back();
      for(std::size_t v = curve.first_node(c); v < curve.first_node(c + 1); ++v) {
        m_points.back().push_back(curve.point(v));
        m_boxes.back().extend(to_vector(curve.point(v)));
      }
    }
  }

  Link_status operator()(const std::vector<Unknot_proof>& proofs)
  {
    if(!is_link(m_curve)) return Link_status::NOT_A_LINK;
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

  bool can_be_taken_apart()
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

  bool is_apart(std::size_t c, std::size_t other)
  {
    return !m_boxes[c].intersects(m_boxes[other]) ||
           (m_points[c].size() == 3 && does_disk_miss(m_points[c], m_points[other])) ||
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
  std::vector<Box> m_boxes;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINK_TRIVIALITY_H
