// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles a loop around an obstacle. Obstacles are cavities of a domain: this domain lies between
// a tetrahedron and a torus inside. The loop leads through the hole of the torus, and ends tight
// around the tube.

#include <CGAL/Volume_filling_curves/add_obstacle.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Curve = VFC::Curve_network_3<>;

// A point of a torus by its angles around the tube and around the axis, both in full turns
Point_3 point_around(double tube_radius, double around_tube, double around_axis)
{
  const double s = 2 * CGAL_PI * around_tube, t = 2 * CGAL_PI * around_axis;
  const double radius = 1 + tube_radius * std::cos(s);
  return {radius * std::cos(t), radius * std::sin(t), tube_radius * std::sin(s)};
}

Mesh make_torus(double tube_radius)
{
  Mesh mesh;
  const std::size_t n = 20, m = 40;
  std::vector<Mesh::Vertex_index> grid;
  for(std::size_t k = 0; k < n * m; ++k)
    grid.push_back(mesh.add_vertex(
        point_around(tube_radius, static_cast<double>(k % n) / n, static_cast<double>(k / n) / m)));
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < m; ++j) {
      const std::size_t i2 = (i + 1) % n, j2 = (j + 1) % m;
      mesh.add_face(grid[i + n * j], grid[i2 + n * j], grid[i2 + n * j2]);
      mesh.add_face(grid[i + n * j], grid[i2 + n * j2], grid[i + n * j2]);
    }
  return mesh;
}

int main()
{
  const double tube_radius = 0.4;
  Mesh boundary;
  CGAL::make_tetrahedron(Point_3(-9, -9, -9), Point_3(9, 9, -9), Point_3(9, -9, 9),
                         Point_3(-9, 9, 9), boundary);
  VFC::add_obstacle(boundary, make_torus(tube_radius));

  std::vector<Point_3> loop; // with bulges
  for(int k = 0; k <= 150; ++k) {
    const double t = (k % 150) / 150., bulge = std::cos(10 * CGAL_PI * t);
    loop.push_back(point_around(0.7 + 0.2 * bulge, t, 0.1 * std::sin(14 * CGAL_PI * t)));
  }
  Curve curve(loop);
  //! [obstacle]
  const VFC::Untangling_result result =
      VFC::untangle(curve, boundary, VFC::parameters::thickness(0.15).stop_at_proof(false));
  //! [obstacle]
  // In space the loop is an unknot; here it cannot get off the torus.
  std::cout << result.status << " after " << result.statistics.iterations << " iterations, length "
            << VFC::length(curve) << '\n';
  return VFC::length(curve) > 0.95 * 2 * CGAL_PI * tube_radius ? EXIT_SUCCESS : EXIT_FAILURE;
}
