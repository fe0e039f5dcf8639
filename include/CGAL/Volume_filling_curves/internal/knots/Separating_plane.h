// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_SEPARATING_PLANE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_SEPARATING_PLANE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for a plane that separates the convex hulls of two point sets: Gilbert's iteration (1966)
// approaches the shortest vector between the hulls in double arithmetic, and every plane orthogonal
// to an iterate that seems to separate them is verified exactly, with the orientation predicate. A
// plane found is a proof; none may be found for hulls that nearly touch. Linear time per iteration.
template <typename Traits>
class Separating_plane
{
public:
  using Point_3 = typename Traits::Point_3;
  using Points = std::vector<Point_3>;

  explicit Separating_plane(const Traits& traits) : m_traits(traits) {}

  // returns whether a plane was found that has all of p strictly on one side and all of q strictly
  // on the other
  bool operator()(const Points& p, const Points& q) const
  {
    constexpr int max_iterations = 200;
    Vector nearest = to_vector(p.front()) - to_vector(q.front());
    for(int k = 0; k < max_iterations; ++k) {
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
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_SEPARATING_PLANE_H
