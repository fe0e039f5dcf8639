// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// User code that makes a curve and untangles it.

#include <CGAL/Volume_filling_curves/untangle.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <vector>

int main()
{
  using Curve = CGAL::Volume_filling_curves::Curve_network_3<>;
  const std::vector<Curve::Point_3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<std::size_t, 2>> edges = {{0, 1}, {1, 2}, {2, 0}};
  Curve curve(points, edges);
  const auto result = CGAL::Volume_filling_curves::untangle(curve);
  std::cout << result.thickness << '\n';
}
