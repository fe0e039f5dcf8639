// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_RATIONAL_GEOMETRY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_RATIONAL_GEOMETRY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/format.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Intersection tests of a replay, in rational arithmetic, independent of the predicates of the
// guard: a segment p + t (q - p) is clipped by the half-spaces whose intersection is the other set,
// and the test is whether anything remains. A triangle is the intersection of five half-spaces, a
// segment or a line of six or more; degenerate positions need no special cases. Constant time; some
// microseconds per test.

using Rational = CGAL::Exact_rational;
using Rational_vector = std::array<Rational, 3>;

inline Rational_vector operator-(const Rational_vector& u, const Rational_vector& v)
{
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

inline Rational dot(const Rational_vector& u, const Rational_vector& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

inline Rational_vector cross(const Rational_vector& u, const Rational_vector& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

inline bool is_zero(const Rational_vector& u)
{
  return u[0] == 0 && u[1] == 0 && u[2] == 0;
}

inline Rational_vector rational(const Position& p)
{
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}

// The part of a segment pq where functions that are linear along it are not negative.
class Clipped_segment
{
public:
  Clipped_segment(Rational_vector p, Rational_vector q) : m_p(std::move(p)), m_q(std::move(q)) {}

  bool is_empty() const { return m_is_empty; }

  // f is an affine function of a point.
  template <typename Function>
  void clip(const Function& f)
  {
    if(m_is_empty) return;
    const Rational at_p = f(m_p), change = f(m_q) - at_p;
    if(change == 0) {
      m_is_empty = at_p < 0;
      return;
    }
    const Rational root = -at_p / change;
    if(change > 0)
      m_lower = (std::max)(m_lower, root);
    else
      m_upper = (std::min)(m_upper, root);
    m_is_empty = m_lower > m_upper;
  }

  template <typename Function>
  void clip_to_zero(const Function& f)
  {
    clip(f);
    clip([&](const Rational_vector& x) { return Rational(-f(x)); });
  }

  void clip_to_line(const Rational_vector& point, const Rational_vector& direction)
  {
    for(std::size_t k = 0; k < 3; ++k)
      clip_to_zero([&](const Rational_vector& x) { return cross(x - point, direction)[k]; });
  }

  void clip_to_point(const Rational_vector& point)
  {
    for(std::size_t k = 0; k < 3; ++k)
      clip_to_zero([&](const Rational_vector& x) { return Rational(x[k] - point[k]); });
  }

  // returns whether f is positive on the remaining part
  template <typename Function>
  bool is_positive(const Function& f) const
  {
    const Rational at_p = f(m_p), change = f(m_q) - at_p;
    return m_is_empty || (at_p + m_lower * change > 0 && at_p + m_upper * change > 0);
  }

private:
  Rational_vector m_p, m_q;
  Rational m_lower = 0, m_upper = 1;
  bool m_is_empty = false;
};

// returns whether the closed segment pq and the closed triangle abc, which may be degenerate, meet
inline bool do_meet_exactly(const Position& p,
                            const Position& q,
                            const std::array<Position, 3>& triangle)
{
  Clipped_segment segment(rational(p), rational(q));
  const std::array<Rational_vector, 3> corners = {rational(triangle[0]), rational(triangle[1]),
                                                  rational(triangle[2])};
  const Rational_vector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  if(is_zero(normal)) {
    const auto [first, last] = std::minmax_element(triangle.begin(), triangle.end());
    const Rational_vector u = rational(*first), v = rational(*last), direction = v - u;
    if(is_zero(direction)) segment.clip_to_point(u);
    segment.clip_to_line(u, direction);
    segment.clip([&](const Rational_vector& x) { return dot(x - u, direction); });
    segment.clip([&](const Rational_vector& x) { return dot(v - x, direction); });
    return !segment.is_empty();
  }
  segment.clip_to_zero([&](const Rational_vector& x) { return dot(x - corners[0], normal); });
  for(std::size_t k = 0; k < 3 && !segment.is_empty(); ++k) {
    const Rational_vector inwards = cross(normal, corners[(k + 1) % 3] - corners[k]);
    segment.clip([&](const Rational_vector& x) { return dot(x - corners[k], inwards); });
  }
  return !segment.is_empty();
}

// returns whether the direction from the apex to s is a sum of multiples >= 0 of those to q and r.
// \pre the apex differs from q and r, and does not lie between them
inline bool is_in_cone_exactly(const Position& apex,
                               const Position& s,
                               const Position& q,
                               const Position& r)
{
  const Rational_vector o = rational(apex), ds = rational(s) - o, dq = rational(q) - o,
                        dr = rational(r) - o, normal = cross(dq, dr);
  if(is_zero(normal)) return is_zero(cross(ds, dq)) && dot(ds, dq) > 0;
  return dot(ds, normal) == 0 && dot(cross(dq, ds), normal) >= 0 && dot(cross(ds, dr), normal) >= 0;
}

// returns whether a lies on the closed segment pq
inline bool is_on_segment_exactly(const Position& a, const Position& p, const Position& q)
{
  Clipped_segment segment(rational(p), rational(q));
  segment.clip_to_point(rational(a));
  return !segment.is_empty();
}

// returns whether the segment pq meets the line ac at most strictly between a and c
inline bool passes_between_exactly(const Position& p,
                                   const Position& q,
                                   const Position& a,
                                   const Position& c)
{
  const Rational_vector ra = rational(a), rc = rational(c), direction = rc - ra;
  Clipped_segment segment(rational(p), rational(q));
  segment.clip_to_line(ra, direction);
  return segment.is_positive([&](const Rational_vector& x) { return dot(x - ra, direction); }) &&
         segment.is_positive([&](const Rational_vector& x) { return dot(rc - x, direction); });
}

inline bool are_collinear_exactly(const Position& a, const Position& b, const Position& c)
{
  return is_zero(cross(rational(b) - rational(a), rational(c) - rational(a)));
}

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_RATIONAL_GEOMETRY_H
