// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fills polygons with holes in the plane, from a file in well-known text (WKT) or a plate.
//
//   fill_polygon [FILE [THICKNESS]]

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/WKT.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace VFC = CGAL::Volume_filling_curves;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_with_holes_2<Kernel>;

const char* const plate = "POLYGON((0 0, 30 0, 30 20, 0 20, 0 0), "
                          "(5 5, 5 15, 10 15, 10 5, 5 5), (17 10, 21 14, 25 10, 21 6, 17 10))";

int main(int argc, char** argv)
{
  std::ifstream file(argc > 1 ? argv[1] : "");
  std::istringstream text(plate);
  const double thickness = argc > 2 ? std::atof(argv[2]) : 0.8;

  //! [fill]
  Polygon polygon;
  if(!CGAL::IO::read_polygon_WKT(argc > 1 ? file : static_cast<std::istream&>(text), polygon))
    return EXIT_FAILURE;
  VFC::Curve_network_3<> curve; // empty: fill() starts where the polygon is widest
  const auto result = VFC::fill(curve, polygon, VFC::parameters::thickness(thickness));
  //! [fill]
  std::cout << result.status << " after " << result.statistics.iterations << " iterations\n"
            << "length          " << VFC::length(curve) << '\n'
            << "within r        " << 100 * result.coverage.fraction_within_r << " % of the area\n"
            << "99 % are within " << result.coverage.p99 << " r\n"
            << "least distance  " << VFC::min_clearance(curve, result.thickness)
            << " between strands\n";
  for(const auto v : curve.nodes())
    if(curve.point(v).z() != 0) return EXIT_FAILURE;
  if(!CGAL::IO::write_curve_network("planar_filling.obj", curve)) return EXIT_FAILURE;
  return result.status == VFC::Filling_status::CONVERGED ? EXIT_SUCCESS : EXIT_FAILURE;
}
