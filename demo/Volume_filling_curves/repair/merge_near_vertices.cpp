// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "meshes/examine_mesh.h"
#include "meshes/mesh_size.h"
#include "options/numbers.h"
#include "repair/Groups.h"

#include <CGAL/box_intersection_d.h>

#include <cstddef>
#include <vector>

namespace vfc {
namespace {

constexpr double reach_of_rounding =
    1e-6; // of the diagonal; a float, as in STL files, has 6e-8 of its size

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

std::vector<Box> boxes_at_borders(const Mesh& mesh, double reach)
{
  std::vector<Box> boxes;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    if(!mesh.is_border(v)) continue;
    const auto& p = mesh.point(v);
    boxes.push_back(Box({p.x() - reach / 2, p.y() - reach / 2, p.z() - reach / 2, p.x() + reach / 2,
                         p.y() + reach / 2, p.z() + reach / 2},
                        v));
  }
  return boxes;
}

// Where holes touch in a vertex a mesh needs two of them.
bool is_same_place(const Mesh& mesh, const Box& a, const Box& b)
{
  return mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(a.info()))) ==
         mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(b.info())));
}

} // namespace

std::string merge_near_vertices(Mesh& mesh, Work_watch& watch)
{
  std::vector<Box> boxes = boxes_at_borders(mesh, reach_of_rounding * diagonal(mesh));
  Groups groups(mesh.number_of_vertices());
  std::size_t merged = 0;
  const auto merge = [&](const Box& a, const Box& b) {
    watch.check();
    if(is_same_place(mesh, a, b) || groups.of(a.info()) == groups.of(b.info())) return;
    groups.unite(a.info(), b.info());
    ++merged;
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), merge);
  if(merged == 0) return "";
  Mesh_soup soup = soup_of(mesh);
  for(Mesh_soup::Face& face : soup.faces)
    for(std::size_t& v : face) v = groups.of(v);
  assemble_faces(soup, mesh, watch);
  return counted(merged, "vertex of a border merged with another one",
                 "vertices of borders merged with others") +
         " at the same place, but for rounding";
}

} // namespace vfc
