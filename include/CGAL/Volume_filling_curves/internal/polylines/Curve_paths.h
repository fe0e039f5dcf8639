// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_CURVE_PATHS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_CURVE_PATHS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Paths of a network between ends and junctions, for output as polylines. A path is a list of
// nodes; a closed component is one path that repeats its first node at the end. Edges keep their
// order and direction, hence a reader numbers the nodes as the network does. Linear time. \pre the
// network has no garbage
struct Curve_paths
{
  template <typename Network>
  explicit Curve_paths(const Network& network)
  {
    CGAL_precondition_msg(!network.has_garbage(), "the network has no garbage");
    points.reserve(network.number_of_nodes());
    for(std::size_t v = 0; v < network.number_of_nodes(); ++v) {
      const auto& p = network.point(v);
      points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
      if(network.is_pinned(v)) pinned.push_back(v);
    }
    for(std::size_t e = 0; e < network.number_of_edges(); ++e) {
      const std::size_t v = network.source(e);
      const bool continues = !paths.empty() && paths.back().back() == v && network.degree(v) == 2;
      if(!continues) paths.push_back({v});
      paths.back().push_back(network.target(e));
    }
  }

  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> paths;
  std::vector<std::size_t> pinned;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_CURVE_PATHS_H
