// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fills a closed mesh, from a file or an icosahedron, with a curve.
//
//   fill_mesh [FILE [THICKNESS]]

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Mesh = CGAL::Surface_mesh<Curve::Point_3>;

int main(int argc, char** argv)
{
  Mesh mesh;
  if(argc < 2)
    CGAL::make_icosahedron(mesh, Curve::Point_3(0, 0, 0), 1);
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return EXIT_FAILURE;
  const double thickness = argc > 2 ? std::atof(argv[2]) : 0; // 0: by the widest ball inside

  //! [fill]
  // throws if the mesh bounds no domain; fill() also takes the mesh itself
  const VFC::Triangle_mesh_domain_3 domain(mesh);
  Curve curve; // empty: fill() starts where the domain is widest
  const auto result = VFC::fill(curve, domain, VFC::parameters::thickness(thickness));

  const VFC::Domain_samples_3 samples(domain);
  const auto distances = VFC::sample_distances(curve, samples);
  const VFC::Coverage coverage = VFC::coverage(samples, distances, result.thickness);
  //! [fill]
  std::cout << result.statistics.iterations << " iterations, " << curve.number_of_nodes()
            << " nodes\n"
            << "thickness       " << result.thickness << '\n'
            << "medial radius   " << result.medial_radius << '\n'
            << "within it       " << 100 * coverage.fraction_within_r << " % of the volume\n"
            << "99 % are within " << coverage.p99 << " times the thickness, all within "
            << coverage.max << '\n';
  for(const auto& region : result.empty_regions)
    std::cout << "not reached: a volume of " << region.volume << " at " << region.point << '\n';

  // Verifies with exact predicates that every edge is strictly inside.
  if(!VFC::containment(curve, domain).is_inside()) return EXIT_FAILURE;
  if(!CGAL::IO::write_curve_network("filling.obj", curve)) return EXIT_FAILURE;
  return result.status == VFC::Filling_status::CONVERGED ? EXIT_SUCCESS : EXIT_FAILURE;
}
