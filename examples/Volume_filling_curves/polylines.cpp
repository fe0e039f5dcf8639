// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles a closed polyline in place, and prints where on the input the points of the result come
// from.

#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int main()
{
  // A ring with large waves. It is closed, since the last point repeats the first.
  std::vector<Point_3> polyline;
  for(int i = 0; i < 200; ++i) {
    const double t = 2 * CGAL_PI * i / 200, radius = 2 + std::cos(9 * t);
    polyline.emplace_back(radius * std::cos(t), radius * std::sin(t), std::sin(9 * t));
  }
  polyline.push_back(polyline.front());

  //! [polylines]
  std::vector<VFC::Curve_origin> origins;
  const auto result = VFC::untangle(polyline, VFC::parameters::origins(std::ref(origins)));

  std::cout << result.status << " with " << polyline.size() << " points\n";
  for(std::size_t i = 0; i < polyline.size(); i += 10)
    std::cout << polyline[i] << " was between the points " << origins[i].source << " and "
              << origins[i].target << '\n';
  //! [polylines]
  return result.status == VFC::Untangling_status::UNKNOTTED ? EXIT_SUCCESS : EXIT_FAILURE;
}
