// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MAKE_NETWORK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MAKE_NETWORK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/IO/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/Curve_checker.h>
#include <CGAL/Volume_filling_curves/internal/IO/Curve_file.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Checks what was read and, if there is no error, makes a network of it: the one way from a file to
// a network, so that no network starts with a self-contact. The points keep their places, hence
// origins are vertices of the file.
template <typename Traits>
bool make_network(Curve_file& file,
                  Curve_network_3<Traits>& network,
                  std::vector<Curve_defect>& defects,
                  Junctions junctions)
{
  check_curve(file, junctions);
  defects = file.defects.listed();
  if(file.defects.has_error()) return false;
  const auto construct_point = network.traits().construct_point_3_object();
  std::vector<typename Traits::Point_3> points;
  points.reserve(file.points.size());
  for(const auto& p : file.points) points.push_back(construct_point(p[0], p[1], p[2]));
  network = Curve_network_3<Traits>(points, file.edges, network.traits());
  std::vector<bool> is_pinned(points.size(), false);
  for(const std::size_t v : file.pinned) is_pinned[v] = true;
  for(std::size_t v = 0; v < network.number_of_nodes(); ++v)
    if(is_pinned[network.origin(v)]) network.set_pinned(v);
  return true;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MAKE_NETWORK_H
