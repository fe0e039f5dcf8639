// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RAY_TURN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RAY_TURN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Ball around a curve. A closing ray that starts inside is long enough to leave it in any
// direction.
struct Ball
{
  Vector center;
  double radius = 0;

  // returns where a ray ends
  Vector tip(const Vector& start, const Vector& direction) const
  {
    return start + (radius + (start - center).norm()) * direction;
  }
};

// Test whether two closures of an open curve have the same type: along its rays, and away from the
// mean of its nodes. They do if the rays, taken as straight, can turn from the one to the other,
// one after another, and the triangles that they sweep meet nothing. Exact. Linear per ray.
template <typename Network>
class Ray_turn
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Traits::Point_3;

public:
  // `mean` is that of the nodes of the curve without its rays
  Ray_turn(const Network& curve, const Ball& ball, const Vector& mean)
      : m_curve(curve),
        m_predicates(curve.traits()),
        m_ball(ball),
        m_mean(mean),
        m_is_of_ray(curve.number_of_nodes(), false)
  {}

  // Takes the nodes of a ray from its tip to the end of the curve.
  void add_ray(const std::vector<std::size_t>& nodes)
  {
    m_rays.push_back({nodes.back(), m_curve.point(nodes.front())});
    for(const std::size_t v : nodes) m_is_of_ray[v] = v != nodes.back();
  }

  bool operator()()
  {
    for(std::size_t k = 0; k < m_rays.size(); ++k) {
      const Vector p = to_vector(m_curve.point(m_rays[k].end));
      const Point_3 tip = to_point(m_ball.tip(p, (p - m_mean).normalized()), m_curve.traits());
      if(!is_turn_free(k, tip)) return false;
      m_rays[k].tip = tip;
    }
    return true;
  }

private:
  struct Closing_ray
  {
    std::size_t end;
    Point_3 tip;
  };

  bool is_turn_free(std::size_t k, const Point_3& tip) const
  {
    const std::size_t end = m_rays[k].end;
    const Point_3 &p = m_curve.point(end), &old_tip = m_rays[k].tip;
    for(std::size_t e = 0; e < m_curve.number_of_edges(); ++e) {
      const std::size_t s = m_curve.source(e), t = m_curve.target(e);
      if(m_is_of_ray[s] || m_is_of_ray[t]) continue;
      const bool is_met = s == end || t == end
                              ? m_predicates.does_segment_meet_triangle_beyond_corner(
                                    p, m_curve.point(s == end ? t : s), old_tip, tip)
                              : m_predicates.does_segment_meet_triangle(
                                    m_curve.point(s), m_curve.point(t), p, old_tip, tip);
      if(is_met) return false;
    }
    for(std::size_t l = 0; l < m_rays.size(); ++l)
      if(l != k && m_predicates.does_segment_meet_triangle(m_curve.point(m_rays[l].end),
                                                           m_rays[l].tip, p, old_tip, tip))
        return false;
    return true;
  }

  const Network& m_curve;
  Exact_predicates<Traits> m_predicates;
  Ball m_ball;
  Vector m_mean;
  std::vector<Closing_ray> m_rays;
  std::vector<bool> m_is_of_ray; // per node
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RAY_TURN_H
