// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RAY_DIRECTIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RAY_DIRECTIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A ball around a curve. A straight ray that starts inside it is long enough to leave it in any
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

// Chooses where straight rays from the ends of a curve go: away from the center of a ball or,
// where a ray would meet the curve or a ray before it, in the nearest of some random directions
// that does not. Exact; O(n log^2 n) per attempt, and few attempts.
template <typename Network>
class Ray_directions
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Traits::Point_3;

public:
  // \pre the curve is embedded
  Ray_directions(const Network& curve, const std::vector<std::size_t>& ends, const Ball& ball)
      : m_curve(curve), m_ends(ends), m_ball(ball)
  {
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) m_points.push_back(curve.point(v));
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      m_edges.push_back({curve.source(e), curve.target(e)});
    for(const std::size_t v : ends) {
      m_edges.push_back({v, m_points.size()});
      m_points.push_back(tip(v, Vector()));
    }
  }

  // Returns where they end.
  std::vector<Point_3> tips()
  {
    Random_source random(0);
    for(int attempt = 1; has_contact(); ++attempt) {
      if(attempt == most_attempts) refuse_end();
      const double tilt = std::ldexp(1., (std::min)(attempt - halvings, 1));
      for(std::size_t k = 0; k < m_ends.size(); ++k)
        if(m_is_in_contact[k])
          m_points[m_curve.number_of_nodes() + k] = tip(m_ends[k], tilt * random.direction());
    }
    return {m_points.end() - static_cast<std::ptrdiff_t>(m_ends.size()), m_points.end()};
  }

private:
  static constexpr int most_attempts = 100;
  static constexpr int halvings = 12; // the first direction tried is off by 2^-11

  [[noreturn]] void refuse_end() const
  {
    const auto k = std::find(m_is_in_contact.begin(), m_is_in_contact.end(), true);
    const auto v = m_ends[static_cast<std::size_t>(k - m_is_in_contact.begin())];
    throw std::invalid_argument("node " + std::to_string(v) + ", an end, is shut in by the curves");
  }

  Point_3 tip(std::size_t v, const Vector& tilt) const
  {
    const Vector p = to_vector(m_curve.point(v)), outwards = p - m_ball.center;
    const Vector direction = outwards.norm() > 0 ? outwards.normalized() : Vector(1, 0, 0);
    return to_point(m_ball.tip(p, (direction + tilt).normalized()), m_curve.traits());
  }

  // Of two rays that meet the second one is to blame.
  bool has_contact()
  {
    Self_contacts<Traits> contacts(m_points, m_edges, m_curve.traits());
    contacts.find((std::numeric_limits<std::size_t>::max)());
    m_is_in_contact.assign(m_ends.size(), false);
    for(const auto& [e, f] : contacts.kept()) m_is_in_contact[f - m_curve.number_of_edges()] = true;
    return contacts.count() > 0;
  }

  const Network& m_curve;
  const std::vector<std::size_t>& m_ends;
  Ball m_ball;
  std::vector<Point_3> m_points; // the tips at the end
  std::vector<std::array<std::size_t, 2>> m_edges;
  std::vector<bool> m_is_in_contact;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_RAY_DIRECTIONS_H
