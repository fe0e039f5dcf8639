// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_EXACT_BRUTE_FORCE_H
#define VFC_TEST_EXACT_BRUTE_FORCE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

// The exact predicates, decided in another way: two convex hulls meet iff the hull of their points'
// differences contains the origin, and then (Caratheodory) so does a simplex of at most four of the
// differences. No case distinctions between degenerate and other positions. NT is an integer type
// for lattice points, or a rational one.
namespace brute_force {

template <typename NT>
using Vec = std::array<NT, 3>;

template <typename NT>
Vec<NT> operator-(const Vec<NT>& a, const Vec<NT>& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <typename NT>
Vec<NT> operator+(const Vec<NT>& a, const Vec<NT>& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <typename NT>
Vec<NT> operator*(const NT& s, const Vec<NT>& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

template <typename NT>
NT dot(const Vec<NT>& a, const Vec<NT>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename NT>
Vec<NT> cross(const Vec<NT>& a, const Vec<NT>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <typename NT>
NT det(const Vec<NT>& a, const Vec<NT>& b, const Vec<NT>& c)
{
  return dot(a, cross(b, c));
}

template <typename NT>
bool is_zero(const Vec<NT>& a)
{
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

template <typename NT>
int sign_of(const NT& x)
{
  return (x > 0) - (x < 0);
}

// whether the origin lies in the segment, triangle or tetrahedron; false if that is degenerate

template <typename NT>
bool contains_origin(const Vec<NT>& x, const Vec<NT>& y)
{
  return is_zero(cross(x, y)) && dot(x, y) <= 0;
}

template <typename NT>
bool contains_origin(const Vec<NT>& x, const Vec<NT>& y, const Vec<NT>& z)
{
  if(det(x, y, z) != 0) return false;
  const Vec<NT> xy = cross(x, y), yz = cross(y, z), zx = cross(z, x), normal = xy + yz + zx;
  return !is_zero(normal) && dot(xy, normal) >= 0 && dot(yz, normal) >= 0 && dot(zx, normal) >= 0;
}

template <typename NT>
bool contains_origin(const Vec<NT>& x, const Vec<NT>& y, const Vec<NT>& z, const Vec<NT>& w)
{
  const NT parts[] = {det(y, z, w), -det(x, z, w), det(x, y, w), -det(x, y, z)};
  const int sign = sign_of<NT>(parts[0] + parts[1] + parts[2] + parts[3]);
  return sign != 0 &&
         std::all_of(parts, parts + 4, [&](const NT& part) { return sign_of(part) != -sign; });
}

template <typename NT>
bool does_hull_contain_origin(const std::vector<Vec<NT>>& x)
{
  const std::size_t n = x.size();
  for(std::size_t i = 0; i < n; ++i) {
    if(is_zero(x[i])) return true;
    for(std::size_t j = 0; j < i; ++j) {
      if(contains_origin(x[i], x[j])) return true;
      for(std::size_t k = 0; k < j; ++k) {
        if(contains_origin(x[i], x[j], x[k])) return true;
        for(std::size_t l = 0; l < k; ++l)
          if(contains_origin(x[i], x[j], x[k], x[l])) return true;
      }
    }
  }
  return false;
}

// returns whether the convex hulls of two point sets meet
template <typename NT>
bool do_hulls_meet(const std::vector<Vec<NT>>& a, const std::vector<Vec<NT>>& b)
{
  std::vector<Vec<NT>> differences;
  for(const Vec<NT>& p : a)
    for(const Vec<NT>& q : b) differences.push_back(p - q);
  return does_hull_contain_origin(differences);
}

// returns whether u is a sum of multiples >= 0 of v and w. \pre u is not zero
template <typename NT>
bool is_in_cone(const Vec<NT>& u, const Vec<NT>& v, const Vec<NT>& w)
{
  const Vec<NT> zero = {0, 0, 0};
  const Vec<NT> back = zero - u;
  return (!is_zero(v) && contains_origin(back, v)) || (!is_zero(w) && contains_origin(back, w)) ||
         (!is_zero(cross(v, w)) && det(u, v, w) == 0 && dot(cross(u, w), cross(v, w)) >= 0 &&
          dot(cross(v, u), cross(v, w)) >= 0);
}

// returns whether the segment ps and the triangle pqr have more in common than p
template <typename NT>
bool do_meet_beyond_corner(const Vec<NT>& p, const Vec<NT>& s, const Vec<NT>& q, const Vec<NT>& r)
{
  return is_in_cone(s - p, q - p, r - p);
}

// returns whether the segment bc meets the line ad outside the open segment ad, where `far` is so
// large that the line meets nothing beyond a + far (a - d) and d + far (d - a)
template <typename NT>
bool does_meet_line_outside(
    const Vec<NT>& b, const Vec<NT>& c, const Vec<NT>& a, const Vec<NT>& d, const NT& far)
{
  return do_hulls_meet<NT>({b, c}, {a, a + far * (a - d)}) ||
         do_hulls_meet<NT>({b, c}, {d, d + far * (d - a)});
}

} // namespace brute_force

#endif // VFC_TEST_EXACT_BRUTE_FORCE_H
