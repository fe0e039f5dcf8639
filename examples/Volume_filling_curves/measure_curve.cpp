// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Measures a link: a trefoil with a ring around one of its strands.

#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Point_3 = Curve::Point_3;
using Polyline = std::vector<Point_3>;

// The polylines are closed, since the last point repeats the first.
Polyline trefoil()
{
  Polyline points;
  const int n = 100;
  for(int i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * i / n, radius = 2 + std::cos(3 * t);
    points.emplace_back(radius * std::cos(2 * t), radius * std::sin(2 * t), std::sin(3 * t));
  }
  points.push_back(points.front());
  return points;
}

// Stands upright around the point (3, 0, 0) of the trefoil, whose strand runs there along y and z.
Polyline ring()
{
  Polyline points;
  const int n = 40;
  for(int i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * i / n;
    points.emplace_back(3 + 0.5 * std::cos(t), 0, 0.5 * std::sin(t));
  }
  points.push_back(points.front());
  return points;
}

int main()
{
  const Curve curve(std::vector<Polyline>{trefoil(), ring()});

  //! [measure]
  const VFC::Curve_measures measures = VFC::measure(curve);
  std::cout << "length                   " << measures.length << '\n'
            << "least bend radius        " << measures.min_bend_radius << '\n'
            << "least clearance          " << measures.min_clearance << '\n'
            << "thickness                " << measures.polygonal_thickness << '\n'
            << "ropelength               " << measures.ropelength << '\n'
            << "average crossing number  " << measures.average_crossing_number << '\n'
            << "linking number           " << measures.linking_matrix[0][1] << '\n';
  //! [measure]
  for(double curvature : measures.total_curvatures)
    std::cout << "total curvature / 2 pi   " << curvature / (2 * CGAL_PI) << '\n';

  // The trefoil is knotted, so its total curvature exceeds 4 pi; that of the flat ring is 2 pi.
  const bool is_ok = std::abs(measures.linking_matrix[0][1]) == 1 &&
                     measures.total_curvatures[0] > 4 * CGAL_PI &&
                     std::abs(measures.total_curvatures[1] - 2 * CGAL_PI) < 1e-9;
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
