// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "options/numbers.h"

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <cstddef>
#include <vector>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

std::vector<Mesh::Face_index> flat_faces(const Mesh& mesh)
{
  std::vector<Mesh::Face_index> result;
  for(const Mesh::Face_index f : mesh.faces())
    if(PMP::is_degenerate_triangle_face(f, mesh)) result.push_back(f);
  return result;
}

} // namespace

std::string remove_flat_faces(Mesh& mesh, Work_watch& watch)
{
  const std::size_t number = flat_faces(mesh).size();
  if(number == 0) return "";
  PMP::remove_degenerate_faces(mesh,
                               CGAL::parameters::vertex_point_map(Watched_points(mesh, watch)));
  for(const Mesh::Face_index f : flat_faces(mesh)) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  return counted(number, "face") + " taken out whose corners lie on a line";
}

} // namespace vfc
