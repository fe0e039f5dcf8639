// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_RAY_CROSSING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_RAY_CROSSING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/replay/rational_geometry.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Exact count of the crossings of a ray in direction x with triangles. A ray that meets an edge or
// a vertex, or runs along a face, counts as moved by (0, e, e^2) with an infinitesimal e, which
// misses all edges: comparisons of coordinates count equality as "not above", and a zero
// determinant gets the sign of its change (Edelsbrunner and Muecke 1990). Hence every ray is valid.
// Trying rays until one misses all edges could fail: among coordinates of 2^52 times the size of a
// mesh, few points lie beyond it.

// returns whether the moved source lies, seen along x, where z is less than that of the edge ab
// with the same y, and the edge has a point with that y
inline bool is_below_edge(const Rational_vector& source,
                          const Rational_vector& a,
                          const Rational_vector& b)
{
  const bool is_rising = b[1] > source[1];
  if((a[1] > source[1]) == is_rising) return false;
  const Rational_vector along = b - a, to_source = source - a;
  Rational turn = along[1] * to_source[2] - along[2] * to_source[1];
  if(turn == 0) turn = along[2] != 0 ? -along[2] : along[1]; // of the infinitely small move
  return (turn < 0) == is_rising;
}

// returns whether the moved ray in direction x crosses a triangle.
// \pre the source is not on the triangle
inline bool does_ray_cross(const Position& source, const std::array<Position, 3>& triangle)
{
  const Rational_vector p = rational(source);
  const std::array<Rational_vector, 3> corners = {rational(triangle[0]), rational(triangle[1]),
                                                  rational(triangle[2])};
  bool is_hit = false; // by the line of the ray
  for(std::size_t k = 0; k < 3; ++k)
    is_hit = is_hit != is_below_edge(p, corners[k], corners[(k + 1) % 3]);
  if(!is_hit) return false;
  const Rational_vector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return (dot(normal, corners[0] - p) > 0) == (normal[0] > 0);
}

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_RAY_CROSSING_H
