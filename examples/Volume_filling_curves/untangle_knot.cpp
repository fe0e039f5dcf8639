// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles an unknot that looks knotted: the outline of a narrow ribbon along a trefoil, cut open.

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Point_3 = Curve::Point_3;

// The point with parameter t, from 0 to 2 pi, of a trefoil, shifted upwards
Point_3 point_on_trefoil(double t, double shift)
{
  const double radius = 2 + std::cos(3 * t);
  return {radius * std::cos(2 * t), radius * std::sin(2 * t), std::sin(3 * t) + shift};
}

Curve outline_of_ribbon()
{
  const std::size_t half = 100; // nodes per side
  const double gap = 0.3, width = 0.2;
  std::vector<Point_3> points;
  for(std::size_t i = 0; i < 2 * half; ++i) {
    const bool is_way_back = i >= half;
    const double step = static_cast<double>(is_way_back ? 2 * half - 1 - i : i);
    const double t = gap + (6.28 - 2 * gap) * step / (half - 1);
    points.push_back(point_on_trefoil(t, is_way_back ? -width / 2 : width / 2));
  }
  return Curve(points, VFC::parameters::closure(VFC::Closure::CLOSED));
}

int main()
{
  Curve curve = outline_of_ribbon();
  const VFC::Untangling_result result = VFC::untangle(curve);

  std::cout << "thickness " << result.thickness << ", " << result.statistics.iterations
            << " iterations, " << result.statistics.certified_changes << " certified changes, "
            << result.statistics.refused_changes << " refused\n";
  if(!CGAL::IO::write_curve_network("untangled.obj", curve)) {
    std::cerr << "untangled.obj cannot be written\n";
    return EXIT_FAILURE;
  }
  if(result.status != VFC::Untangling_status::UNKNOTTED) {
    std::cerr << "The curve was not proved to be an unknot\n";
    return EXIT_FAILURE;
  }
  std::cout << "The curve is an unknot, proved by its "
            << (result.proofs[0] == VFC::Unknot_proof::EDGES ? "number of edges"
                                                             : "total curvature")
            << '\n';
  return EXIT_SUCCESS;
}
