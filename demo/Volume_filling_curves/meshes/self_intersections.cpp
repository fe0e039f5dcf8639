// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_checks.h"

#include <CGAL/Volume_filling_curves/internal/domain/intersecting_faces.h>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

static_assert(curves::internal::max_pairs_of_faces == Mesh_findings::max_counted);

std::vector<Face_pair> intersecting_faces(const Mesh& mesh, Work_watch& watch)
{
  return curves::internal::intersecting_faces(mesh, Watched_points(mesh, watch));
}

void report_self_intersections(const Mesh& mesh,
                               const Mesh_soup& soup,
                               Mesh_findings& findings,
                               Work_watch& watch)
{
  for(const Face_pair& pair : intersecting_faces(mesh, watch))
    findings.add_error(curves::internal::intersection_fault(mesh, pair),
                       {0, {}, {soup.face_numbers[pair.first], soup.face_numbers[pair.second]}});
}

} // namespace vfc
