// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/surface_distance.h"

#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Random.h>
#include <CGAL/tags.h>

namespace vfc {

double surface_distance(const Mesh& from, const Mesh& to, Work_watch& watch)
{
  // The parameter random_seed chooses the faces, but not the points on them (CGAL 5.5.1).
  CGAL::get_default_random() = CGAL::Random(0);
  return CGAL::Polygon_mesh_processing::approximate_Hausdorff_distance<CGAL::Sequential_tag>(
      from, to,
      CGAL::parameters::number_of_points_on_faces(8000)
          .number_of_points_on_edges(2000)
          .random_seed(0)
          .vertex_point_map(Watched_points(from, watch)),
      CGAL::parameters::vertex_point_map(Watched_points(to, watch)));
}

} // namespace vfc
