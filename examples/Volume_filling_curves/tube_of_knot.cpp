// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Makes the tube around a knot as a closed mesh for printing.

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/tube_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/STL.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  const auto knot = VFC::make_torus_knot(2, 3, 300);

  //! [tube]
  // Up to the polygonal thickness the tube does not meet itself.
  const double radius = 0.9 * VFC::polygonal_thickness(knot);
  Mesh tube;
  VFC::tube_mesh(knot, radius, tube, VFC::parameters::number_of_sides(24));
  //! [tube]
  std::cout << "faces   " << tube.number_of_faces() << '\n'
            << "volume  " << CGAL::Polygon_mesh_processing::volume(tube) << '\n';
  if(!CGAL::IO::write_STL("knot.stl", tube)) return EXIT_FAILURE;

  // A second tube in the same mesh, with a radius per node
  const auto circle = VFC::make_regular_polygon(100, 10);
  const auto waves = [](std::size_t v) {
    return 1 + 0.3 * std::cos(0.2 * CGAL_PI * static_cast<double>(v));
  };
  VFC::tube_mesh(circle, waves, tube);
  return EXIT_SUCCESS;
}
