// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "meshes/holes.h"
#include "options/numbers.h"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

constexpr std::size_t most_edges = 2000; // of a hole: the time grows with their cube

// returns whether all triangles were found and fit in
bool close(const Hole& hole, Mesh& mesh)
{
  std::vector<Kernel::Point_3> points;
  for(const Mesh::Vertex_index v : hole.vertices) points.push_back(mesh.point(v));
  std::vector<CGAL::Triple<int, int, int>> patch;
  PMP::triangulate_hole_polyline(points, std::back_inserter(patch));
  const auto vertex = [&](int i) { return hole.vertices[static_cast<std::size_t>(i)]; };
  for(const auto& [i, j, k] : patch)
    if(mesh.add_face(vertex(i), vertex(j), vertex(k)) == Mesh::null_face()) return false;
  return !patch.empty();
}

} // namespace

std::string close_holes(Mesh& mesh)
{
  std::size_t closed = 0;
  double width_of_closed = 0;
  for(const Hole& hole : holes_of(mesh)) {
    if(hole.vertices.size() > most_edges || !close(hole, mesh)) continue;
    ++closed;
    width_of_closed = (std::max)(width_of_closed, hole.width);
  }
  return closed == 0 ? ""
                     : std::to_string(closed) + " holes closed, the widest of width " +
                           to_text(width_of_closed);
}

} // namespace vfc
