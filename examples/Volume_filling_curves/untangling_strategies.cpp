// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles a figure-eight knot by each strategy: the flow moves it continuously, the random search
// finds a polygon with few edges, and both together find an even, smooth shape.

#include <CGAL/Volume_filling_curves/curve_measures.h>
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
using Point_3 = Curve::Point_3;

// A figure-eight knot with waves.
Curve figure_eight()
{
  const std::size_t n = 300;
  std::vector<Point_3> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * static_cast<double>(i) / n;
    const double radius = 2 + std::cos(2 * t) + 0.1 * std::cos(30 * t);
    points.emplace_back(radius * std::cos(3 * t), radius * std::sin(3 * t), std::sin(4 * t));
  }
  return Curve(points, VFC::parameters::closure(VFC::Closure::CLOSED));
}

// Follows the search; returning false would end it.
struct Search_observer : VFC::Default_curve_flow_visitor
{
  bool on_search(const VFC::Search_progress& progress)
  {
    edges = progress.edges;
    return true;
  }

  std::size_t edges = 0;
};

bool untangle(const char* name, VFC::Untangling_strategy strategy, std::size_t max_nodes)
{
  Curve curve = figure_eight();
  Search_observer observer;
  //! [strategy]
  const VFC::Untangling_result result = VFC::untangle(
      curve, VFC::parameters::strategy(strategy).random_seed(1).number_of_chains(2).visitor(
                 std::ref(observer)));
  //! [strategy]
  std::cout << name << ": " << curve.number_of_nodes() << " nodes, " << result.statistics.iterations
            << " iterations, " << result.sweeps << " sweeps, " << observer.edges
            << " edges found, crossing number " << VFC::average_crossing_number(curve) << '\n';
  return result.status == VFC::Untangling_status::CONVERGED && curve.number_of_nodes() <= max_nodes;
}

int main()
{
  bool is_ok = untangle("flow", VFC::Untangling_strategy::FLOW, 300);
  is_ok &= untangle("search", VFC::Untangling_strategy::SEARCH, 8); // the minimum is 7
  is_ok &= untangle("auto", VFC::Untangling_strategy::AUTO, 300);
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
