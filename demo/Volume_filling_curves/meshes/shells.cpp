// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/shells.h"

#include "meshes/shell_places.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

struct Shell
{
  std::vector<Mesh::Face_index> faces;
  std::optional<std::size_t> parent; // the shell directly around, if there is one
  bool is_right = true;              // whether it is turned as its depth wants it
  bool is_mixed = false;             // whether its faces disagreed
};

// The faces of the shells, in the order of their first ones.
std::vector<std::vector<Mesh::Face_index>> faces_of_shells(const Mesh& mesh)
{
  std::vector<std::size_t> shell_of(mesh.number_of_faces());
  const auto shells = PMP::connected_components(
      mesh, boost::make_iterator_property_map(shell_of.begin(), get(CGAL::face_index, mesh)));
  std::vector<std::vector<Mesh::Face_index>> result(shells);
  for(const Mesh::Face_index f : mesh.faces()) result[shell_of[f]].push_back(f);
  return result;
}

std::vector<Shell> shells_of(const Mesh& mesh, const std::vector<bool>& is_turned)
{
  const auto faces = faces_of_shells(mesh);
  const std::vector<Shell_place> places = places_of_shells(mesh, faces);
  const auto depth = [&](std::size_t shell) { return places[shell].around.size(); };
  std::vector<Shell> shells(faces.size());
  for(std::size_t i = 0; i < shells.size(); ++i) {
    shells[i].faces = faces[i];
    shells[i].is_right = places[i].is_outward == (depth(i) % 2 == 0);
    for(const std::size_t outer : places[i].around)
      if(depth(outer) + 1 == depth(i)) shells[i].parent = outer;
    for(const Mesh::Face_index f : faces[i])
      shells[i].is_mixed = shells[i].is_mixed || is_turned[f];
  }
  return shells;
}

void report_ambiguous(const std::vector<Shell>& shells,
                      const Mesh_soup& soup,
                      Mesh_findings& findings)
{
  for(std::size_t i = 0; i < shells.size(); ++i) {
    if(!shells[i].parent) continue;
    const Shell &inner = shells[i], &outer = shells[*shells[i].parent];
    if(inner.is_right == outer.is_right || inner.is_mixed || outer.is_mixed) continue;
    findings.add_error(
        "ambiguous shells",
        "shell " + std::to_string(i + 1) + " lies within shell " +
            std::to_string(*shells[i].parent + 1) + " and is turned the same way",
        {0, {}, {soup.face_numbers[inner.faces[0]], soup.face_numbers[outer.faces[0]]}, i + 1});
  }
}

void report_mixed(const std::vector<Shell>& shells,
                  const std::vector<bool>& is_turned,
                  const Mesh_soup& soup,
                  Mesh_findings& findings)
{
  std::vector<std::size_t> faces;
  for(const Shell& shell : shells)
    for(const Mesh::Face_index f : shell.faces)
      if(shell.is_mixed && is_turned[f] == shell.is_right) faces.push_back(soup.face_numbers[f]);
  if(!faces.empty())
    findings.add_warning("mixed orientation",
                         std::to_string(faces.size()) +
                             " faces were turned against their neighbors and have been reoriented",
                         {0, {}, faces});
}

} // namespace

void orient_shells(Mesh& mesh,
                   const std::vector<bool>& is_turned,
                   const Mesh_soup& soup,
                   Mesh_findings& findings)
{
  const std::vector<Shell> shells = shells_of(mesh, is_turned);
  report_mixed(shells, is_turned, soup, findings);
  report_ambiguous(shells, soup, findings);
  if(findings.has_error()) return;
  for(std::size_t i = 0; i < shells.size(); ++i) {
    if(shells[i].is_right) continue;
    PMP::reverse_face_orientations(shells[i].faces, mesh);
    if(!shells[i].is_mixed)
      findings.add_warning("inverted orientation",
                           "shell " + std::to_string(i + 1) + " was turned inside out",
                           {0, {}, {}, i + 1});
  }
}

} // namespace vfc
