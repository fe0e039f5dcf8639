// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_checks.h"

#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/domain/nested_shells.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace rules = CGAL::Volume_filling_curves::internal;

using Shells = std::vector<rules::Nested_shell<Mesh>>;

// Which shells have faces that disagreed.
std::vector<bool> mixed(const Shells& shells, const std::vector<bool>& is_turned)
{
  std::vector<bool> result;
  for(const auto& shell : shells)
    result.push_back(std::any_of(shell.faces.begin(), shell.faces.end(),
                                 [&](Mesh::Face_index f) { return is_turned[f]; }));
  return result;
}

void report_ambiguous(const Shells& shells,
                      const std::vector<bool>& are_mixed,
                      const Mesh_soup& soup,
                      Mesh_findings& findings)
{
  for(std::size_t i = 0; i < shells.size(); ++i) {
    if(!rules::is_ambiguous(shells, i)) continue;
    const std::size_t outer = *shells[i].parent;
    if(are_mixed[i] || are_mixed[outer]) continue;
    findings.add_error(
        rules::ambiguity_fault(shells, i),
        {0,
         {},
         {soup.face_numbers[shells[i].faces[0]], soup.face_numbers[shells[outer].faces[0]]},
         i + 1});
  }
}

void report_mixed(const Shells& shells,
                  const std::vector<bool>& are_mixed,
                  const std::vector<bool>& is_turned,
                  const Mesh_soup& soup,
                  Mesh_findings& findings)
{
  std::vector<std::size_t> faces;
  for(std::size_t i = 0; i < shells.size(); ++i)
    for(const Mesh::Face_index f : shells[i].faces)
      if(are_mixed[i] && is_turned[f] == shells[i].is_right) faces.push_back(soup.face_numbers[f]);
  if(!faces.empty())
    findings.add_warning("mixed orientation",
                         counted(faces.size(), "face was turned against its neighbors and has",
                                 "faces were oriented against their neighbors and have") +
                             " been reoriented",
                         {0, {}, faces});
}

} // namespace

void orient_shells(Mesh& mesh,
                   const std::vector<bool>& is_turned,
                   const Mesh_soup& soup,
                   Mesh_findings& findings)
{
  const Shells shells = rules::nested_shells(mesh);
  const std::vector<bool> are_mixed = mixed(shells, is_turned);
  report_mixed(shells, are_mixed, is_turned, soup, findings);
  report_ambiguous(shells, are_mixed, soup, findings);
  if(findings.has_error()) return;
  for(std::size_t i = 0; i < shells.size(); ++i) {
    if(shells[i].is_right) continue;
    PMP::reverse_face_orientations(shells[i].faces, mesh);
    if(!are_mixed[i])
      findings.add_warning("inverted orientation",
                           "shell " + std::to_string(i + 1) + " was turned inside out",
                           {0, {}, {}, i + 1});
  }
}

} // namespace vfc
