// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_SEPARATING_DIRECTIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_SEPARATING_DIRECTIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Quick proofs in double arithmetic, which spare a replay most rational numbers: a direction in
// which two sets are separated by more than the rounding error proves that they are disjoint.
// Nothing proves the contrary. The bound 1e-14 is more than ten times the worst rounding error of
// the sums below, in any rounding mode; where products underflow or overflow nothing is proved.
// Constant time, some ten nanoseconds.

inline Position difference(const Position& u, const Position& v)
{
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

inline Position cross(const Position& u, const Position& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

inline Position sum(const Position& u, const Position& v)
{
  return {u[0] + v[0], u[1] + v[1], u[2] + v[2]};
}

// returns a vector with the direction of u and a length of about 1
inline Position unit(const Position& u)
{
  const double length = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  return {u[0] / length, u[1] / length, u[2] / length};
}

inline Position scaled(double factor, const Position& u)
{
  return {factor * u[0], factor * u[1], factor * u[2]};
}

// returns the sign of the product of a direction with the vector between two points, 0 if rounding
// leaves it uncertain
inline int certain_sign(const Position& direction, const Position& from, const Position& to)
{
  constexpr double error = 1e-14, underflow = 1e-300;
  double product = 0, bound = 0;
  for(std::size_t k = 0; k < 3; ++k) {
    const double term = direction[k] * (to[k] - from[k]);
    product += term;
    bound += std::abs(term);
  }
  bound = error * bound + underflow;
  return product > bound ? 1 : product < -bound ? -1 : 0;
}

// returns whether the direction surely separates the two sets
template <typename Points1, typename Points2>
bool are_apart_in_direction(const Points1& set1, const Points2& set2, const Position& direction)
{
  const int sign = certain_sign(direction, set1[0], set2[0]);
  if(sign == 0) return false;
  for(const Position& p : set1)
    for(const Position& q : set2)
      if(certain_sign(direction, p, q) != sign) return false;
  return true;
}

// returns whether a segment and a triangle are surely disjoint. If disjoint sets are in general
// position, or in a plane, one of the tested directions separates them.
inline bool are_surely_apart(const std::array<Position, 2>& segment,
                             const std::array<Position, 3>& triangle)
{
  const auto is_separating = [&](const Position& direction) {
    return are_apart_in_direction(segment, triangle, direction);
  };
  const auto& [a, b, c] = triangle;
  const std::array<Position, 3> sides = {difference(b, a), difference(c, b), difference(a, c)};
  const Position normal = cross(sides[0], sides[1]), along = difference(segment[1], segment[0]);
  if(is_separating(difference(a, segment[0])) || is_separating(normal)) return true;
  for(const Position& side : sides)
    if(is_separating(cross(along, side)) || is_separating(cross(normal, side))) return true;
  return is_separating(cross(cross(along, sides[0]), along)) ||
         is_separating(cross(cross(along, sides[1]), along));
}

// returns whether the direction from the apex to s is surely no sum of multiples >= 0 of those to
// q and r
inline bool is_surely_outside_cone(const Position& apex,
                                   const Position& s,
                                   const Position& q,
                                   const Position& r)
{
  const auto is_separating = [&](const Position& direction) {
    return certain_sign(direction, apex, s) > 0 && certain_sign(direction, apex, q) < 0 &&
           certain_sign(direction, apex, r) < 0;
  };
  const Position ds = unit(difference(s, apex)), dq = unit(difference(q, apex)),
                 dr = unit(difference(r, apex));
  if(is_separating(difference(ds, dq)) || is_separating(difference(ds, dr))) return true;
  // slightly inclined away from the cone
  constexpr double inclination = 1e-4;
  const Position away = scaled(-inclination, sum(dq, dr));
  const Position normal = unit(cross(dq, dr)), q_side = unit(cross(normal, dq)),
                 r_side = unit(cross(dr, normal));
  return is_separating(sum(normal, away)) || is_separating(sum(scaled(-1, normal), away)) ||
         is_separating(sum(scaled(-1, q_side), away)) ||
         is_separating(sum(scaled(-1, r_side), away));
}

// returns whether all of pq surely projects strictly between a and c on the line through them
inline bool surely_projects_between(const Position& p,
                                    const Position& q,
                                    const Position& a,
                                    const Position& c)
{
  const Position direction = difference(c, a);
  for(const Position& x : {p, q})
    if(certain_sign(direction, a, x) <= 0 || certain_sign(direction, x, c) <= 0) return false;
  return true;
}

// returns whether the three points are surely not on a line
inline bool are_surely_not_collinear(const Position& a, const Position& b, const Position& c)
{
  constexpr double error = 1e-14, underflow = 1e-300;
  const Position u = difference(b, a), v = difference(c, a);
  for(std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double plus = u[i] * v[j], minus = u[j] * v[i];
    if(std::abs(plus - minus) > error * (std::abs(plus) + std::abs(minus)) + underflow) return true;
  }
  return false;
}

// Box with sides parallel to the axes.
struct Extent
{
  Position lower = {infinity(), infinity(), infinity()},
           upper = {-infinity(), -infinity(), -infinity()};

  void add(const Position& p)
  {
    for(std::size_t k = 0; k < 3; ++k) {
      lower[k] = (std::min)(lower[k], p[k]);
      upper[k] = (std::max)(upper[k], p[k]);
    }
  }

  bool meets(const Extent& other) const
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(upper[k] < other.lower[k] || other.upper[k] < lower[k]) return false;
    return true;
  }

private:
  static double infinity() { return std::numeric_limits<double>::infinity(); }
};

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_SEPARATING_DIRECTIONS_H
