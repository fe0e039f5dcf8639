// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_checks.h"

#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/domain/mesh_holes.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace rules = CGAL::Volume_filling_curves::internal;

using Vertex_pair = std::pair<std::size_t, std::size_t>;

// Findings of CGAL's orientation of a soup.
struct Orientation
{
  std::map<Vertex_pair, std::size_t> bad_edges; // with the number of their faces
  std::vector<std::size_t> touching_vertices;
  std::vector<bool> is_turned; // of the faces
};

struct Orientation_visitor : PMP::Default_orientation_visitor
{
  explicit Orientation_visitor(Orientation* found = nullptr) : m_found(found) {}

  void non_manifold_edge(std::size_t v, std::size_t w, std::size_t number_of_faces)
  {
    m_found->bad_edges[std::minmax(v, w)] = number_of_faces;
  }

  void non_manifold_vertex(std::size_t v, std::size_t) { m_found->touching_vertices.push_back(v); }

  void polygon_orientation_reversed(std::size_t f) { m_found->is_turned[f] = true; }

private:
  Orientation* m_found;
};

void report_bad_edges(const Orientation& found, const Mesh_soup& soup, Mesh_findings& findings)
{
  for(const auto& [edge, number_of_faces] : found.bad_edges)
    findings.add_error("non-manifold edge",
                       "an edge has " + std::to_string(number_of_faces) + " faces" +
                           near_text(soup.points[edge.first]),
                       {0, soup.numbers({edge.first, edge.second})});
}

void report_touching_vertices(const Orientation& found,
                              const Mesh_soup& soup,
                              Mesh_findings& findings)
{
  const std::vector<std::size_t>& vertices = found.touching_vertices;
  if(!vertices.empty())
    findings.add_warning("non-manifold vertex",
                         "the surface touches itself in " +
                             counted(vertices.size(), "vertex", "vertices"),
                         {0, soup.numbers(vertices)});
}

// Along edges with more than two faces the mesh has been cut, which is no hole of the file.
void report_holes(const Orientation& found,
                  const Mesh& mesh,
                  const Mesh_soup& soup,
                  Mesh_findings& findings)
{
  std::set<Vertex_pair> cuts; // by places, which the two sides of a cut share
  for(const auto& [edge, number_of_faces] : found.bad_edges)
    cuts.insert(std::minmax(soup.file_index(edge.first), soup.file_index(edge.second)));
  for(const auto& hole : rules::holes_of(mesh)) {
    const std::vector<std::size_t> vertices(hole.vertices.begin(), hole.vertices.end());
    bool is_cut = true;
    for(std::size_t i = 0, last = vertices.size() - 1; i < vertices.size(); last = i++)
      is_cut = is_cut && cuts.count(std::minmax(soup.file_index(vertices[last]),
                                                soup.file_index(vertices[i]))) > 0;
    if(is_cut) continue;
    findings.add_error(rules::hole_fault(mesh, hole), {0, soup.numbers(vertices)});
  }
}

} // namespace

Mesh closed_surface(Mesh_soup& soup, Mesh_findings& findings, Work_watch& watch)
{
  Orientation found{{}, {}, std::vector<bool>(soup.faces.size(), false)};
  if(!is_closed_and_oriented(soup))
    PMP::orient_polygon_soup(soup.points, soup.faces,
                             CGAL::parameters::visitor(Orientation_visitor(&found)));
  report_bad_edges(found, soup, findings);
  watch.check();
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  watch.check();
  report_holes(found, mesh, soup, findings);
  report_self_intersections(mesh, soup, findings, watch);
  if(findings.has_error()) return mesh;
  orient_shells(mesh, found.is_turned, soup, findings);
  report_touching_vertices(found, soup, findings);
  return mesh;
}

} // namespace vfc
