// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Follows an untangling with a visitor, ends it half-way, and continues it.

#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;

//! [visitor]
// Prints every fourth iteration and ends the run when the curve is short enough.
struct Length_visitor : VFC::Default_curve_flow_visitor
{
  double wanted_length;

  explicit Length_visitor(double length) : wanted_length(length) {}

  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    if(flow.statistics().iterations % 4 == 0)
      std::cout << "iteration " << flow.statistics().iterations << ": length " << flow.length()
                << ", " << flow.curve().number_of_nodes() << " nodes\n";
  }

  template <typename Flow>
  bool go_further(const Flow& flow)
  {
    return flow.length() > wanted_length;
  }
};
//! [visitor]

// The trefoil as a loose knot on a torus
Curve trefoil()
{
  const std::size_t n = 120;
  std::vector<Curve::Point_3> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * static_cast<double>(i) / n, radius = 2 + std::cos(3 * t);
    points.emplace_back(radius * std::cos(2 * t), radius * std::sin(2 * t), std::sin(3 * t));
  }
  return Curve(points, VFC::parameters::closure(VFC::Closure::CLOSED));
}

int main()
{
  using VFC::parameters::thickness;

  Curve curve = trefoil();
  Length_visitor visitor(20.);
  const VFC::Untangling_result half_way = VFC::untangle<CGAL::Parallel_if_available_tag>(
      curve, thickness(0.5).visitor(std::ref(visitor)));
  if(half_way.status != VFC::Untangling_status::INTERRUPTED) return EXIT_FAILURE;
  std::cout << "interrupted\n";

  // The curve is valid, so another run can continue: until it is tight, or for 10 seconds.
  visitor.wanted_length = 0;
  const VFC::Untangling_result result = VFC::untangle<CGAL::Parallel_if_available_tag>(
      curve, thickness(0.5).tolerance(0.01).time_limit(10).number_of_iterations(1000).visitor(
                 std::ref(visitor)));
  if(result.status == VFC::Untangling_status::CONVERGED)
    std::cout << "The trefoil is tight, with a gradient norm of " << result.gradient_norm << '\n';
  return result.status == VFC::Untangling_status::CONVERGED ? EXIT_SUCCESS : EXIT_FAILURE;
}
