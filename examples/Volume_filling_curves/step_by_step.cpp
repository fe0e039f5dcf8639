// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Runs the flow step by step, and reads medial spheres and the gradient between steps.

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Flow = VFC::Curve_flow_3<>;

// A figure-eight knot
Curve figure_eight()
{
  const std::size_t n = 150;
  std::vector<Curve::Point_3> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * static_cast<double>(i) / n, radius = 2 + std::cos(2 * t);
    points.emplace_back(radius * std::cos(3 * t), radius * std::sin(3 * t), std::sin(4 * t));
  }
  return Curve(points, VFC::parameters::closure(VFC::Closure::CLOSED));
}

// The share of medial spheres that touch another node; all others have the largest radius.
double share_of_touching_spheres(const Flow& flow)
{
  std::size_t touching = 0, all = 0;
  for(std::size_t v = 0; v < flow.curve().number_of_nodes(); ++v)
    for(const auto& sphere : flow.medial_spheres(v)) {
      ++all;
      if(sphere.touched_node != Curve::null_node()) ++touching;
    }
  return static_cast<double>(touching) / static_cast<double>(all);
}

int main()
{
  //! [parameters]
  VFC::Curve_flow_parameters parameters;
  parameters.thickness = 0.3; // in the unit of the points
  parameters.number_of_directions = 24;

  Curve curve = figure_eight();
  VFC::Isotopy_guard_3 guard(curve);
  Flow flow(guard, parameters);
  //! [parameters]
  const double start_length = flow.length();
  //! [steps]
  for(int k = 0; k <= 20; ++k) {
    if(k % 5 == 0) {
      const double strongest_pull = flow.gradient().rowwise().norm().maxCoeff();
      std::cout << "length " << flow.length() << ", gradient norm " << flow.gradient_norm()
                << ", strongest pull " << strongest_pull << ", touching spheres "
                << 100 * share_of_touching_spheres(flow) << " %\n";
    }
    if(!flow.step()) {
      std::cerr << "Step " << k << " could not be certified\n";
      return EXIT_FAILURE;
    }
  }
  //! [steps]
  const VFC::Curve_flow_statistics statistics = flow.statistics();
  std::cout << statistics.certified_changes << " changes of nodes, " << statistics.shortened_steps
            << " shortened steps\n";
  return flow.length() < start_length ? EXIT_SUCCESS : EXIT_FAILURE;
}
