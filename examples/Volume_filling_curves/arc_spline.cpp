// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Makes a smooth curve of arcs and segments of a filling, certified to stay inside the ball.

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/arc_spline.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

int main()
{
  const VFC::Ball_domain_3<> ball({0, 0, 0}, 1);
  VFC::Curve_network_3<> curve;
  VFC::fill(curve, ball, VFC::parameters::thickness(0.25));

  //! [arcs]
  const auto spline = VFC::arc_spline(curve, ball);
  for(const VFC::Arc_conflict& conflict : spline.conflicts)
    std::cout << "the corner at node " << conflict.node << " is not certified\n";
  //! [arcs]
  std::cout << spline.number_of_arcs << " arcs, " << spline.number_of_segments
            << " segments, least radius " << spline.min_radius << ", within " << spline.max_distance
            << " of the polygon\n";

  std::ofstream out("filling.txt");
  for(const auto& path : spline.paths)
    for(const auto& piece : path.pieces)
      out << (piece.is_arc() ? "arc " : "line ") << piece.start << ' ' << piece.middle << ' '
          << piece.end << '\n';
  return spline.is_certified && out ? EXIT_SUCCESS : EXIT_FAILURE;
}
