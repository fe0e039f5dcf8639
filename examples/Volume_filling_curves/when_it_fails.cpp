// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Runs that miss their goal, and what to do: rejected input, a limit, and a thickness that does not
// fit.

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Point_3 = Curve::Point_3;
using VFC::Filling_status;
using VFC::Untangling_status;

bool is_refused()
{
  //! [refused]
  const std::vector<Point_3> points = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  Curve curve(points, VFC::parameters::closure(VFC::Closure::CLOSED)); // two edges cross
  try {
    VFC::untangle(curve);
  } catch(const std::invalid_argument& error) {
    std::cout << error.what() << '\n'; // names the nodes; the curve is unchanged
    return true;
  }
  //! [refused]
  return false;
}

bool goes_on_after_a_limit()
{
  //! [limit]
  Curve curve = VFC::make_torus_knot(2, 5, 300);
  auto result = VFC::untangle(curve, VFC::parameters::number_of_iterations(20));
  while(result.status == Untangling_status::LIMIT) // with the same thickness
    result = VFC::untangle(curve, VFC::parameters::thickness(result.thickness).time_limit(10));
  //! [limit]
  std::cout << result.status << '\n';
  return result.status == Untangling_status::CONVERGED;
}

bool finds_a_thickness_that_fits()
{
  //! [thin]
  const VFC::Box_domain_3<> plate({0, 0, 0}, {1, 1, 0.1});
  Curve curve;
  const auto preview = VFC::parameters::round_bends(false);
  auto result = VFC::fill(curve, plate, preview.thickness(0.12));
  if(result.status == Filling_status::PARTIAL) {
    std::cout << result.reason << '\n';
    const double thickness = result.thickness_fit.fitting_thickness;
    curve = Curve();
    result = VFC::fill(curve, plate, preview.thickness(thickness));
  }
  //! [thin]
  std::cout << result.status << " with " << result.thickness << '\n';
  return result.status == Filling_status::CONVERGED;
}

int main()
{
  const bool is_ok = is_refused() && goes_on_after_a_limit() && finds_a_thickness_that_fits();
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
