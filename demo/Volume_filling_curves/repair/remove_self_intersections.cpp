// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "meshes/examine_mesh.h"
#include "meshes/mesh_size.h"
#include "options/numbers.h"
#include "repair/Face_selection.h"
#include "repair/shells_apart.h"
#include "repair/surface_distance.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <vector>

// CGAL's function for this smooths the whole box around each group of faces, over and over, which
// takes the product of their number and size: 46 s for a tire of 21,600 faces. All groups are dealt
// with at once here, in 1 s. They are cut out, as by Attene, A lightweight approach to repairing
// digitized polygon meshes, 2010; noise is too dense for that and is smoothed.

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

constexpr std::size_t max_rings = 7;        // of faces around those that intersect
constexpr std::size_t max_smoothings = 10;  // of noise; 3 do if it is as long as edges
constexpr double max_area_of_scraps = 0.01; // each; the area of the shell is 1

// Beyond these the shell changes too much, and a wrap is closer to it.
constexpr double min_area = 0.5;     // of the shell's
constexpr double max_distance = 0.1; // of the shell's diagonal

// returns the faces that are not selected, without the scraps among them
Mesh rest_of(const Mesh& shell, const Face_selection& selection, Work_watch& watch)
{
  Mesh_soup rest = soup_of(shell);
  std::size_t kept = 0;
  for(const Mesh::Face_index f : shell.faces())
    if(!selection.has(f)) rest.faces[kept++] = rest.faces[f];
  rest.faces.resize(kept);
  Mesh mesh;
  assemble_faces(rest, mesh, watch);
  std::vector<Mesh> parts = shells_apart(mesh);
  const double scrap = max_area_of_scraps * PMP::area(shell);
  const auto is_scrap = [&](const Mesh& part) { return PMP::area(part) < scrap; };
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_scrap), parts.end());
  return shells_together(parts);
}

// Cuts out intersecting faces, and closes the gaps; where that makes new intersections, cuts out
// ever more around them.
void cut_out(Mesh& shell, Work_watch& watch)
{
  for(std::size_t rings = 0; rings < max_rings; ++rings) {
    Face_selection selection(shell, watch);
    if(selection.is_empty()) return;
    for(std::size_t i = 0; i < rings; ++i) selection.add_ring(shell);
    shell = rest_of(shell, selection, watch);
    close_holes(shell, watch);
  }
}

// Moves vertices to the middles of their neighbors, all at once.
void smooth(Mesh& shell, const std::vector<Mesh::Vertex_index>& vertices)
{
  std::vector<Kernel::Point_3> middles;
  for(const Mesh::Vertex_index v : vertices) {
    Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
    for(const Mesh::Vertex_index w : shell.vertices_around_target(shell.halfedge(v)))
      sum = sum + (shell.point(w) - CGAL::ORIGIN);
    middles.push_back(CGAL::ORIGIN + sum / static_cast<double>(shell.degree(v)));
  }
  for(std::size_t i = 0; i < vertices.size(); ++i) shell.point(vertices[i]) = middles[i];
}

void smooth_out(Mesh& shell, Work_watch& watch)
{
  for(std::size_t i = 0; i < max_smoothings; ++i) {
    Face_selection selection(shell, watch);
    if(selection.is_empty()) return;
    selection.add_ring(shell);
    smooth(shell, selection.vertices(shell));
  }
}

bool is_mended(const Mesh& mesh, const Mesh& shell, Work_watch& watch)
{
  return !mesh.is_empty() && CGAL::is_closed(mesh) && Face_selection(mesh, watch).is_empty() &&
         PMP::area(mesh) > min_area * PMP::area(shell) &&
         surface_distance(mesh, shell, watch) < max_distance * diagonal(shell);
}

// returns whether the shell had some and has none after this; else it is as it was
bool mend(Mesh& shell, Work_watch& watch)
{
  if(Face_selection(shell, watch).is_empty()) return false;
  for(const bool is_noise : {false, true}) {
    Mesh mesh = shell;
    if(is_noise) smooth_out(mesh, watch);
    cut_out(mesh, watch);
    if(!is_mended(mesh, shell, watch)) continue;
    shell = mesh;
    return true;
  }
  return false;
}

// Returns false on input that CGAL does not expect.
bool try_to_mend(Mesh& shell, Work_watch& watch)
{
  try {
    return mend(shell, watch);
  } catch(const std::exception&) {
    return false;
  }
}

} // namespace

std::string remove_self_intersections(Mesh& mesh, Work_watch& watch)
{
  std::vector<Mesh> shells = shells_apart(mesh);
  std::size_t mended = 0;
  for(Mesh& shell : shells) mended += try_to_mend(shell, watch) ? 1 : 0;
  if(mended == 0) return "";
  mesh = shells_together(shells);
  return "self-intersections of " + counted(mended, "shell") + " cut out";
}

} // namespace vfc
