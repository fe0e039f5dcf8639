// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_POLYGON_TEST_SUPPORT_H
#define VFC_TEST_POLYGON_TEST_SUPPORT_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cmath>
#include <vector>

// Polygons to be filled.
namespace polygons {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corner = Kernel::Point_2;
using Ring = CGAL::Polygon_2<Kernel>;
using Polygon = CGAL::Polygon_with_holes_2<Kernel>;

inline Ring ring(const std::vector<Corner>& corners)
{
  return {corners.begin(), corners.end()};
}

inline Ring rectangle(double x, double y, double width, double height)
{
  return ring({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

// A regular polygon around (x, y).
inline Ring disk(double x, double y, double radius, int corners = 24)
{
  Ring ring;
  for(int k = 0; k < corners; ++k) {
    const double angle = 2 * CGAL_PI * k / corners;
    ring.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return ring;
}

inline Polygon polygon(const Ring& outer, const std::vector<Ring>& holes = {})
{
  return Polygon(outer, holes.begin(), holes.end());
}

// A rectangle of 3 x 2 with two holes.
inline Polygon plate()
{
  return polygon(rectangle(-1.5, -1, 3, 2), {disk(.7, .2, .35), disk(-.6, -.2, .45)});
}

} // namespace polygons

#endif // VFC_TEST_POLYGON_TEST_SUPPORT_H
