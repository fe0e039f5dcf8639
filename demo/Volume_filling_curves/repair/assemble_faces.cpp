// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "options/numbers.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <algorithm>
#include <cstddef>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

std::size_t drop_faces_without_three_corners(std::vector<Mesh_soup::Face>& faces)
{
  const auto has_two = [](const Mesh_soup::Face& f) {
    return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
  };
  const auto end = std::remove_if(faces.begin(), faces.end(), has_two);
  const auto number = static_cast<std::size_t>(faces.end() - end);
  faces.erase(end, faces.end());
  return number;
}

} // namespace

std::string assemble_faces(const Mesh_soup& soup, Mesh& mesh, Work_watch& watch)
{
  auto points = soup.points;
  auto faces = soup.faces;
  PMP::merge_duplicate_points_in_polygon_soup(points, faces);
  watch.check();
  const std::size_t degenerate = drop_faces_without_three_corners(faces);
  const std::size_t repeated = PMP::merge_duplicate_polygons_in_polygon_soup(points, faces);
  PMP::remove_isolated_points_in_polygon_soup(points, faces); // they belong to no valid mesh
  watch.check();
  PMP::orient_polygon_soup(points, faces);
  watch.check();
  mesh.clear();
  PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
  watch.check();
  PMP::stitch_borders(mesh);
  mesh.collect_garbage(); // stitching leaves gaps in the numbering
  std::string done;
  if(degenerate > 0) done = counted(degenerate, "face") + " without three corners dropped";
  if(repeated > 0)
    done += (done.empty() ? "" : ", ") + counted(repeated, "repeated face") + " dropped";
  return done;
}

} // namespace vfc
