// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_BRUTE_FORCE_CURVE_H
#define VFC_TEST_BRUTE_FORCE_CURVE_H

#include "support/exact_brute_force.h"

#include <cstdint>
#include <numeric>
#include <vector>

// A curve on the integer lattice, the criteria under which the guard must accept a change of it,
// and what these criteria promise: that the curve is embedded at every time. All by brute force.
namespace brute_force {

using Integer = std::int64_t;
using Lattice_point = Vec<Integer>;

struct Curve
{
  std::vector<Lattice_point> points;
  std::vector<std::array<std::size_t, 2>> edges;

  std::vector<std::size_t> edges_at(std::size_t v) const
  {
    std::vector<std::size_t> found;
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(edges[e][0] == v || edges[e][1] == v) found.push_back(e);
    return found;
  }

  std::size_t opposite(std::size_t v, std::size_t e) const
  {
    return edges[e][0] == v ? edges[e][1] : edges[e][0];
  }

  // the node that two edges have in common, or the number of nodes
  std::size_t common_node(std::size_t e, std::size_t f) const
  {
    for(std::size_t v : edges[e])
      if(v == edges[f][0] || v == edges[f][1]) return v;
    return points.size();
  }

  std::vector<Lattice_point> segment(std::size_t e) const
  {
    return {points[edges[e][0]], points[edges[e][1]]};
  }
};

// returns whether two edges meet at most in a common node
inline bool is_pair_embedded(const Curve& curve, std::size_t e, std::size_t f)
{
  const std::size_t v = curve.common_node(e, f);
  if(v == curve.points.size()) return !do_hulls_meet(curve.segment(e), curve.segment(f));
  const Lattice_point x = curve.points[curve.opposite(v, e)] - curve.points[v];
  const Lattice_point y = curve.points[curve.opposite(v, f)] - curve.points[v];
  return !(is_zero(cross(x, y)) && dot(x, y) >= 0);
}

inline bool is_embedded(const Curve& curve)
{
  for(std::size_t e = 0; e < curve.edges.size(); ++e) {
    if(curve.points[curve.edges[e][0]] == curve.points[curve.edges[e][1]]) return false;
    for(std::size_t f = 0; f < e; ++f)
      if(!is_pair_embedded(curve, e, f)) return false;
  }
  return true;
}

// returns whether edge e meets the closed triangle only in those of its corners a and c that are
// nodes of e, and does not join a and c, which may be the same
inline bool does_avoid(const Curve& curve,
                       std::size_t e,
                       const std::array<Lattice_point, 3>& triangle,
                       std::size_t a,
                       std::size_t c)
{
  const auto [s, t] = curve.edges[e];
  if((s == a && t == c) || (s == c && t == a)) return false;
  const auto meets_beyond = [&](std::size_t corner, std::size_t k) {
    return do_meet_beyond_corner(curve.points[corner], curve.points[curve.opposite(corner, e)],
                                 triangle[k], triangle[k + 1]);
  };
  if(s == a || t == a) return !meets_beyond(a, 1);
  if(s == c || t == c) return !meets_beyond(c, 0);
  return !do_hulls_meet(curve.segment(e), {triangle[0], triangle[1], triangle[2]});
}

constexpr std::size_t no_node = static_cast<std::size_t>(-1);

// the criterion for replacing the edge ac by ab, bc or back; `taken_out` says which edges go
template <typename Is_taken_out>
bool may_replace(const Curve& curve,
                 std::size_t a,
                 const Lattice_point& b,
                 std::size_t c,
                 const Is_taken_out& is_taken_out)
{
  const Lattice_point &pa = curve.points[a], &pc = curve.points[c];
  if(is_zero(cross(b - pa, pc - pa))) return dot(b - pa, b - pc) < 0;
  for(std::size_t e = 0; e < curve.edges.size(); ++e)
    if(!is_taken_out(e) && !does_avoid(curve, e, {pa, b, pc}, a, c)) return false;
  return true;
}

inline bool may_insert(const Curve& curve, std::size_t e, const Lattice_point& b)
{
  return may_replace(curve, curve.edges[e][0], b, curve.edges[e][1],
                     [&](std::size_t f) { return e == f; });
}

inline bool may_remove(const Curve& curve, std::size_t v)
{
  const std::vector<std::size_t> at_v = curve.edges_at(v);
  if(at_v.size() != 2) return false;
  const std::size_t a = curve.opposite(v, at_v[0]), c = curve.opposite(v, at_v[1]);
  for(std::size_t e : curve.edges_at(a))
    if(curve.opposite(a, e) == c) return false;
  return may_replace(curve, a, curve.points[v], c,
                     [&](std::size_t e) { return e == at_v[0] || e == at_v[1]; });
}

// the criterion (i) to (iii) for moving node v
inline bool may_move(const Curve& curve, std::size_t v, const Lattice_point& target)
{
  const Lattice_point& b = curve.points[v];
  if(b == target) return true;
  const std::vector<std::size_t> at_v = curve.edges_at(v);
  for(std::size_t i = 0; i < at_v.size(); ++i) {
    const std::size_t a = curve.opposite(v, at_v[i]);
    const Lattice_point& pa = curve.points[a];
    for(std::size_t e = 0; e < curve.edges.size(); ++e) {
      if(curve.edges[e][0] == v || curve.edges[e][1] == v) continue;
      if(!does_avoid(curve, e, {pa, b, target}, a, a)) return false;
    }
    if(do_hulls_meet<Integer>({pa}, {b, target})) return false;
    for(std::size_t j = 0; j < i; ++j)
      if(does_meet_line_outside<Integer>(b, target, pa, curve.points[curve.opposite(v, at_v[j])],
                                         1000))
        return false;
  }
  return true;
}

// returns whether the nodes may move one after another, in the order of their numbers or reversed
inline bool may_move_all(Curve curve, const std::vector<Lattice_point>& targets, bool is_reversed)
{
  const std::size_t n = curve.points.size();
  for(std::size_t k = 0; k < n; ++k) {
    const std::size_t v = is_reversed ? n - 1 - k : k;
    if(!may_move(curve, v, targets[v])) return false;
    curve.points[v] = targets[v];
  }
  return true;
}

using Fraction = std::array<Integer, 2>;

// All times in [0, 1] at which something about the edges at v can change while v moves straight to
// `target`: the roots of quantities that are linear in time.
inline std::vector<Fraction> critical_times(const Curve& curve,
                                            std::size_t v,
                                            const Lattice_point& target)
{
  std::vector<Fraction> times = {{0, 1}, {1, 1}};
  const Lattice_point& b = curve.points[v];
  const auto add = [&](Integer f, Integer g) { // values at the times 0 and 1
    if(f == g || f * g > 0) return;
    const Integer divisor = std::gcd(f, f - g) * (f - g > 0 ? 1 : -1);
    times.push_back({f / divisor, (f - g) / divisor});
  };
  const auto add_vector = [&](const Lattice_point& f, const Lattice_point& g) {
    for(std::size_t k = 0; k < 3; ++k) add(f[k], g[k]);
  };
  for(std::size_t p = 0; p < curve.points.size(); ++p) {
    const Lattice_point& x = curve.points[p];
    if(p != v) add_vector(b - x, target - x);
    for(std::size_t q = 0; q < p; ++q) {
      const Lattice_point y = curve.points[q] - x;
      if(p != v && q != v) add_vector(cross(b - x, y), cross(target - x, y));
      for(std::size_t r = 0; r < q && p != v && q != v; ++r) {
        const Lattice_point z = curve.points[r] - x;
        if(r != v) add(det(b - x, y, z), det(target - x, y, z));
      }
    }
  }
  std::sort(times.begin(), times.end(),
            [](const Fraction& s, const Fraction& t) { return s[0] * t[1] < t[0] * s[1]; });
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// returns whether the edges at v are embedded at the time t of the way to `target`
inline bool is_embedded_at(const Curve& curve,
                           std::size_t v,
                           const Lattice_point& target,
                           const Fraction& t)
{
  Curve moved = curve;
  for(Lattice_point& p : moved.points) p = t[1] * p;
  moved.points[v] = moved.points[v] + t[0] * (target - curve.points[v]);
  for(std::size_t e : curve.edges_at(v)) {
    if(moved.points[curve.opposite(v, e)] == moved.points[v]) return false;
    for(std::size_t f = 0; f < curve.edges.size(); ++f)
      if(f != e && !is_pair_embedded(moved, e, f)) return false;
  }
  return true;
}

// The truth about a move: tested at all critical times and between each two of them.
inline bool stays_embedded(const Curve& curve, std::size_t v, const Lattice_point& target)
{
  const std::vector<Fraction> times = critical_times(curve, v, target);
  for(std::size_t k = 0; k < times.size(); ++k) {
    const Fraction s = times[k], t = times[k + 1 < times.size() ? k + 1 : k];
    const Fraction middle = {s[0] * t[1] + t[0] * s[1], 2 * s[1] * t[1]};
    if(!is_embedded_at(curve, v, target, s) || !is_embedded_at(curve, v, target, middle))
      return false;
  }
  return true;
}

} // namespace brute_force

#endif // VFC_TEST_BRUTE_FORCE_CURVE_H
