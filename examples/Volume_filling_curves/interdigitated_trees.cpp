// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Two trees grow side by side in a box, each from its port, like the two sides of a heat exchanger.
// They keep their junctions, and a clearance from each other.

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Traits = VFC::Curve_flow_traits_3<>;
using Curve = VFC::Curve_network_3<Traits>;
using Point_3 = Curve::Point_3;
using Domain = VFC::Box_domain_3<Traits>;

// A trunk with two limbs, each with two twigs; node 0 and node 8 are the ports. The second tree is
// the first one, turned around.
Curve two_trees()
{
  std::vector<Point_3> points = {{0.02, 0.5, 0.5}, {0.4, 0.5, 0.5}, {0.8, 0.3, 0.5},
                                 {0.8, 0.7, 0.5},  {1.3, 0.3, 0.7}, {1.3, 0.3, 0.3},
                                 {1.3, 0.7, 0.7},  {1.3, 0.7, 0.3}};
  std::vector<std::array<std::size_t, 2>> edges = {{0, 1}, {1, 2}, {1, 3}, {2, 4},
                                                   {2, 5}, {3, 6}, {3, 7}};
  for(std::size_t v = 0; v < 8; ++v)
    points.emplace_back(2 - points[v].x(), points[v].z(), points[v].y());
  for(std::size_t e = 0; e < 7; ++e) edges.push_back({edges[e][0] + 8, edges[e][1] + 8});
  Curve trees(points, edges);
  trees.set_pinned(0);
  trees.set_pinned(8);
  return trees;
}

double clearance_of_trees(const Curve& trees)
{
  std::vector<CGAL::Epick::Segment_3> segments[2];
  for(std::size_t e = 0; e < trees.number_of_edges(); ++e) {
    const std::size_t v = trees.source(e);
    segments[trees.component(v)].emplace_back(trees.point(v), trees.point(trees.target(e)));
  }
  double least = std::numeric_limits<double>::infinity();
  for(const auto& s : segments[0])
    for(const auto& t : segments[1]) least = (std::min)(least, CGAL::squared_distance(s, t));
  return std::sqrt(least);
}

int main()
{
  const Domain box(Point_3(0, 0, 0), Point_3(2, 1, 1));
  Curve trees = two_trees();
  const auto result = VFC::fill(trees, box, VFC::parameters::thickness(0.1));

  std::size_t junctions = 0;
  for(std::size_t v = 0; v < trees.number_of_nodes(); ++v) junctions += trees.degree(v) > 2;
  const VFC::Domain_samples_3<Traits, Domain> samples(box);
  const auto coverage =
      VFC::coverage(samples, VFC::sample_distances(trees, samples), result.thickness);
  const double clearance = clearance_of_trees(trees);
  std::cout << trees.number_of_components() << " trees with " << junctions << " junctions, "
            << 100 * coverage.fraction_within_r << " % of the volume are within "
            << result.thickness << " of them\n"
            << "clearance between the trees " << clearance << '\n';
  CGAL::IO::write_curve_network("trees.obj", trees);
  return clearance > 0 && junctions == 6 ? EXIT_SUCCESS : EXIT_FAILURE;
}
